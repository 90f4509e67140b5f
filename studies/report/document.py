"""A report as one HTML page without anything from outside: style and script are inside it."""

from base64 import b64encode
from collections.abc import Iterable
from html import escape
from importlib.resources import files

from studies.output.versions import processor, versions
from studies.report.figures import picture_svg, plot_svg
from studies.report.markdown import csv_text
from studies.report.markup import items, note, panels, section, table
from studies.report.parts import Table
from studies.report.study_page import AGREE, Report, Section, Verdict
from studies.report.study_text import shown

MANY = 30  # rows of a table above which it is folded
CONTENTS = 4  # sections above which a page has a list of them
MANY_VERDICTS = 6  # met criteria above which they are folded


def page(report: Report) -> str:
    """The page; UnsupportedError when matplotlib is missing and there is something to plot."""
    return (
        '<!doctype html><html lang="en"><head><meta charset="utf-8">'
        '<meta name="viewport" content="width=device-width, initial-scale=1">'
        f"<title>{escape(report.title)}</title><style>{asset('style.css')}</style></head>"
        f'<body class="report">{body(report)}<script>{asset("script.js")}</script></body></html>\n'
    )


def fragment(report: Report) -> str:
    """The same for a notebook's output, without the script: figures as they are, nothing to hover."""
    return f'<style>{asset("style.css")}</style><div class="report">{body(report)}</div>'


def asset(name: str) -> str:
    """The page's style or script."""
    return files("studies.report").joinpath(name).read_text(encoding="utf-8")


def body(report: Report) -> str:
    """Everything that is seen."""
    sections = [each for each in report.sections if each.has_content]
    places = {each.title: each.name for each in sections}
    head = (
        f'<header><h1>{escape(report.title)}</h1><p class="lead">{escape(report.lead)}</p>'
        f"{items('facts', [('', fact) for fact in report.facts])}</header>"
    )
    return (
        head
        + _warnings(report.warnings)
        + _contents(sections)
        + f"<main>{''.join(_section(each, places) for each in sections)}</main>"
        + _foot(report.footnotes)
    )


def _warnings(warnings: tuple[str, ...]) -> str:
    told = "".join(f"<p>{escape(warning)}</p>" for warning in warnings)
    return f'<div class="warning"><b>What went wrong</b>{told}</div>' if told else ""


def _contents(sections: list[Section]) -> str:
    if len(sections) <= CONTENTS:
        return ""
    links = "".join(f'<li><a href="#{each.name}">{escape(each.title)}</a></li>' for each in sections)
    return f'<nav aria-label="Contents"><ul>{links}</ul></nav>'


def _section(each: Section, places: dict[str, str]) -> str:
    names = list(each.files().items())
    # Tables and files belong to each other one by one, but for a section with files of its own.
    paired = not each.data or len(each.data) == len(each.tables)
    shown_tables = [content for content in each.tables if content.rows]
    tables = [
        _table(content, places, each.title, [names[k]] if paired else [])
        for k, content in enumerate(shown_tables)
    ]
    figures = [
        *(plot_svg(plot, each.name) for plot in each.plots if plot.curves),
        *(picture_svg(picture, each.name) for picture in each.pictures),
        *each.figures,
    ]
    verdicts = _verdicts(each.verdicts)
    if each.at_a_glance:
        shown_parts = [panels(figures, each.caption, "".join(tables)), verdicts]
    else:
        shown_parts = [verdicts, each.controls, panels(figures, each.caption), *tables]
    return section(
        each.title,
        f'<p class="lead">{escape(each.lead)}</p>' if each.lead else "",
        *(note(remark) for remark in each.remarks),
        *shown_parts,
        "" if paired else "".join(_download(*file) for file in names),
        place=each.name,
    )


def _verdicts(verdicts: Iterable[Verdict]) -> str:
    """Verdicts in their order; many that agree are folded, behind those that do not."""
    told = [(each.kind, each.text) for each in verdicts]
    met = [each for each in told if each[0] == AGREE]
    if len(met) <= MANY_VERDICTS:
        return items("verdicts", told) if told else ""
    others = [each for each in told if each[0] != AGREE]
    folded = f"<details><summary>{len(met)} criteria met</summary>{items('verdicts', met)}</details>"
    return (items("verdicts", others) if others else "") + folded


def _table(content: Table, places: dict[str, str], heading: str, file: list[tuple[str, Table]]) -> str:
    title = f"<h3>{escape(content.title)}</h3>" if content.title != heading else ""
    text = table(content.head, [[shown(cell) for cell in row] for row in content.rows], places)
    if len(content.rows) > MANY:
        text = f"<details><summary>{len(content.rows)} rows</summary>{text}</details>"
    return (
        title
        + text
        + "".join(_download(*each) for each in file)
        + (note(content.note) if content.note else "")
    )


def _download(name: str, content: Table) -> str:
    """A link that holds the table: it works without a script and when the page has been sent to somebody."""
    data = b64encode(csv_text(content).encode()).decode()
    return f'<a class="csv" download="{escape(name)}" href="data:text/csv;base64,{data}">{escape(name)}</a>'


def _foot(footnotes: tuple[str, ...]) -> str:
    made = ", ".join(f"{name} {version}" for name, version in versions().items())
    told = "".join(f"<p>{escape(text)}</p>" for text in (*footnotes, made, processor()))
    return f"<footer>{told}</footer>"

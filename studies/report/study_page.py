"""Reports of studies: the same sections as one HTML page, as Markdown and as CSV tables."""

import csv
import io
from collections.abc import Iterable
from dataclasses import dataclass
from html import escape
from importlib.resources import files

from core_models.errors import UnsupportedError
from studies.output_folder import OutputFolder
from studies.report.markup import items, note, panels, section, table
from studies.verification.figures import plot_svg
from studies.verification.outcome import Plot, Table
from studies.verification.text import shown
from studies.versions import processor, versions


@dataclass(frozen=True)
class Section:
    """A heading with sentences, tables and plots; `name` is that of its CSV files."""

    name: str
    title: str
    tables: tuple[Table, ...] = ()
    plots: tuple[Plot, ...] = ()
    remarks: tuple[str, ...] = ()


@dataclass(frozen=True)
class Report:
    """A study's report: title, one sentence of what it is, facts in a few words each, sections."""

    title: str
    lead: str
    facts: tuple[str, ...]
    sections: tuple[Section, ...]


def write_report(report: Report, folder: OutputFolder) -> str:
    """Write report.html, report.md and a CSV file for each table; returns a sentence if the page could not be made."""
    folder.write_text("report.md", markdown(report))
    for each in report.sections:
        for index, content in enumerate(each.tables):
            folder.write_text(f"{each.name}{f'-{index + 1}' if index else ''}.csv", csv_text(content))
    try:
        folder.write_text("report.html", page(report))
    except UnsupportedError as reason:
        return f"{reason}; report.md and the tables are complete"
    return ""


def page(report: Report) -> str:
    """One self-contained HTML page; UnsupportedError when matplotlib is missing and there is something to plot."""
    style = "".join(
        files(package).joinpath("style.css").read_text(encoding="utf-8")
        for package in ("studies.report", "studies.verification")
    )
    head = (
        f'<header><h1>{escape(report.title)}</h1><p class="lead">{escape(report.lead)}</p>'
        + items("facts", [("", fact) for fact in report.facts])
        + "</header>"
    )
    body = head + "".join(_section(each) for each in report.sections) + _foot()
    return (
        '<!doctype html><html lang="en"><head><meta charset="utf-8">'
        '<meta name="viewport" content="width=device-width, initial-scale=1">'
        f"<title>{escape(report.title)}</title><style>{style}</style></head><body>{body}</body></html>\n"
    )


def _section(each: Section) -> str:
    return section(
        each.title,
        *(note(remark) for remark in each.remarks),
        *(_table(content) for content in each.tables if content.rows),
        panels([plot_svg(plot, each.name) for plot in each.plots if plot.curves], ""),
    )


def _table(content: Table) -> str:
    rows = [[escape(shown(cell)) for cell in row] for row in content.rows]
    text = f"<h3>{escape(content.title)}</h3>" + table([escape(name) for name in content.head], rows)
    return text + (note(content.note) if content.note else "")


def _foot() -> str:
    made = ", ".join(f"{name} {version}" for name, version in versions().items())
    return f"<footer><p>{escape(made)}</p><p>{escape(processor())}</p></footer>"


def markdown(report: Report) -> str:
    """The report without its figures, for a pull request."""
    lines = [f"# {report.title}", "", report.lead, "", *(f"* {fact}" for fact in report.facts), ""]
    for each in report.sections:
        lines += [f"## {each.title}", "", *(line for remark in each.remarks for line in (remark, ""))]
        for content in each.tables:
            if content.rows:
                lines += [f"### {content.title}", "", *_markdown_rows(content), ""]
                lines += [content.note, ""] if content.note else []
    return "\n".join(lines)


def _markdown_rows(content: Table) -> Iterable[str]:
    yield "| " + " | ".join(content.head) + " |"
    yield "|" + "---|" * len(content.head)
    for row in content.rows:
        yield "| " + " | ".join(shown(cell).replace("|", "\\|") for cell in row) + " |"


def csv_text(content: Table) -> str:
    """A table as CSV, numbers with all their digits, nothing for what is missing."""
    buffer = io.StringIO()
    writer = csv.writer(buffer, lineterminator="\n")
    writer.writerow(content.head)
    writer.writerows([["" if cell is None else cell for cell in row] for row in content.rows])
    return buffer.getvalue()

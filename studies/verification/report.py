"""The verification report: one self-contained HTML page."""

from html import escape
from importlib.resources import files

from studies.report.markup import items, note, panels, section, table
from studies.verification.figures import picture_svg, plot_svg
from studies.verification.outcome import Outcome, Table
from studies.verification.problem import Problem
from studies.verification.text import criterion_text, shown
from studies.versions import processor, versions

Results = list[tuple[Problem, Outcome]]


def report_page(results: Results, quick: bool, title: str = "Verification") -> str:
    """The page; raises UnsupportedError when matplotlib is missing."""
    style = "".join(
        files(package).joinpath("style.css").read_text(encoding="utf-8")
        for package in ("studies.report", "studies.verification")
    )
    body = "".join(
        [_head(results, quick, title), _summary(results), *(_problem(*each) for each in results), _foot()]
    )
    return (
        '<!doctype html><html lang="en"><head><meta charset="utf-8">'
        '<meta name="viewport" content="width=device-width, initial-scale=1">'
        f"<title>{title}</title><style>{style}</style></head><body>{body}</body></html>\n"
    )


def _head(results: Results, quick: bool, title: str) -> str:
    criteria = [criterion for _, outcome in results for criterion in outcome.criteria]
    facts = [
        f"{sum(criterion.met for criterion in criteria)} of {len(criteria)} criteria met",
        f"{len(results)} problems",
        f"{sum(outcome.seconds for _, outcome in results):.0f} s",
        "quick: coarse and few" if quick else "full",
    ]
    lead = (
        "Problems with known answers, by finite elements and by the material point method. A criterion that is not met "
        "is shown as such; what could not be run says why."
    )
    return (
        f'<header><h1>{title}</h1><p class="lead">{lead}</p>'
        + items("facts", [("", fact) for fact in facts])
        + "</header>"
    )


def _summary(results: Results) -> str:
    rows = []
    for problem, outcome in results:
        met = sum(criterion.met for criterion in outcome.criteria)
        whole = met == len(outcome.criteria)
        mark = (
            '<span class="on">✓</span>'
            if whole
            else f'<span class="bad">{len(outcome.criteria) - met} not met</span>'
        )
        link = f'<a href="#{problem.name}">{escape(problem.title)}</a>'
        rows.append((link, f"{met} / {len(outcome.criteria)}", mark, f"{outcome.seconds:.1f}"))
    return section("In short", table(("Problem", "criteria met", "", "s"), rows))


def _problem(problem: Problem, outcome: Outcome) -> str:
    verdicts = [("agree" if each.met else "apart", criterion_text(each)) for each in outcome.criteria]
    failed = [verdict for verdict in verdicts if verdict[0] == "apart"]
    met = [verdict for verdict in verdicts if verdict[0] == "agree"]
    return (
        f'<div id="{problem.name}">'
        + section(
            problem.title,
            f'<p class="lead">{escape(problem.description)}</p>',
            note(f"Source: {problem.source}."),
            items("verdicts", failed) if failed else "",
            _folded(met),
            panels([plot_svg(plot, problem.name) for plot in outcome.plots if plot.curves], ""),
            *(
                panels([picture_svg(each, problem.name)], f"{each.title}: {each.label}.")
                for each in outcome.pictures
            ),
            *(_table(each) for each in outcome.tables if each.rows),
            *(note(remark) for remark in outcome.remarks),
        )
        + "</div>"
    )


def _folded(met: list[tuple[str, str]]) -> str:
    if not met:
        return ""
    return f"<details open><summary>{len(met)} criteria met</summary>{items('verdicts', met)}</details>"


def _table(content: Table) -> str:
    rows = [[escape(shown(cell)) for cell in row] for row in content.rows]
    head = [escape(name) for name in content.head]
    return f"<h3>{escape(content.title)}</h3>{table(head, rows)}" + (
        note(content.note) if content.note else ""
    )


def _foot() -> str:
    made = ", ".join(f"{name} {version}" for name, version in versions().items())
    return f"<footer><p>{escape(made)}</p><p>{escape(processor())}</p></footer>"

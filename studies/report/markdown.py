"""Reports as Markdown, for a pull request, and their tables as CSV."""

import csv
import io
from collections.abc import Iterable

from studies.report.parts import Table
from studies.report.study_page import AGREE, APART, NEUTRAL, Report, Section
from studies.report.study_text import shown

MARKS = {AGREE: "✓ ", APART: "≠ ", NEUTRAL: "– "}


def markdown(report: Report) -> str:
    """The report without its figures."""
    lines = [f"# {report.title}", "", report.lead, "", *(f"* {fact}" for fact in report.facts), ""]
    if report.warnings:
        lines += ["**What went wrong**", "", *(f"* {warning}" for warning in report.warnings), ""]
    for each in report.sections:
        lines += _section(each)
    lines += [line for footnote in report.footnotes for line in (footnote, "")]
    return "\n".join(lines)


def _section(each: Section) -> Iterable[str]:
    if not (each.verdicts or each.remarks or any(content.rows for content in each.tables)):
        return
    yield from (f"## {each.title}", "")
    for sentence in (each.lead, *each.remarks):
        if sentence:
            yield from (sentence, "")
    yield from (*_tables(each), *_verdicts(each)) if each.at_a_glance else (*_verdicts(each), *_tables(each))


def _verdicts(each: Section) -> Iterable[str]:
    if each.verdicts:
        yield from (f"* {MARKS.get(verdict.kind, '')}{verdict.text}" for verdict in each.verdicts)
        yield ""


def _tables(each: Section) -> Iterable[str]:
    for content in each.tables:
        if content.rows:
            yield from (f"### {content.title}", "") if content.title != each.title else ()
            yield from (*_rows(content), "")
            yield from (content.note, "") if content.note else ()


def _rows(content: Table) -> Iterable[str]:
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

"""How results show themselves in a notebook: pieces of HTML with their own style, without scripts."""

from dataclasses import replace

from core_models.errors import UnsupportedError
from studies.comparisons.comparison import Comparison, conclude
from studies.report.comparison_report import report_of
from studies.report.document import fragment
from studies.report.study_page import Report
from studies.runs.result import RunResult

OF_A_RUN = ("shapes", "quantities", "histories", "energies", "costs")


def comparison_html(comparison: Comparison) -> str:
    """The whole report of a comparison but pictures over time; without matplotlib a hint."""
    try:
        return fragment(report_of(comparison, moving=False))
    except UnsupportedError as reason:
        return fragment(Report(comparison.scene.name, comparison.scene.description, (), (), (str(reason),)))


def run_html(result: RunResult) -> str:
    """Final shape, quantities, histories and energies of one run, or why it went wrong."""
    comparison = conclude(result.scene, result.wall, [result])
    try:
        report = report_of(comparison, moving=False)
    except UnsupportedError as reason:
        return fragment(Report(result.label, result.scene.description, (), (), (str(reason),)))
    sections = tuple(each for each in report.sections if each.name in OF_A_RUN)
    return fragment(replace(report, title=f"{result.scene.name}, {result.label}", sections=sections))

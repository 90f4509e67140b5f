"""The report of a study of problems: a summary, then one section for each problem."""

from studies.report.parts import Table
from studies.report.study_page import AGREE, APART, Report, Section, Verdict
from studies.verification.outcome import Outcome
from studies.verification.problem import Problem
from studies.verification.text import criterion_text

Results = list[tuple[Problem, Outcome]]
LEAD = (
    "Problems with known answers, by finite elements and by the material point method. A criterion that is not met "
    "is shown as such; what could not be run says why."
)


def report_of(results: Results, quick: bool, title: str = "Verification") -> Report:
    """The whole report."""
    criteria = [criterion for _, outcome in results for criterion in outcome.criteria]
    return Report(
        title,
        LEAD,
        (
            f"{sum(criterion.met for criterion in criteria)} of {len(criteria)} criteria met",
            f"{len(results)} problem{'s' if len(results) != 1 else ''}",
            f"{sum(outcome.seconds for _, outcome in results):.0f} s of processor time",
            "quick: coarse and few" if quick else "full",
        ),
        (_summary(results), *(_problem(*each) for each in results)),
    )


def _summary(results: Results) -> Section:
    rows = []
    for problem, outcome in results:
        unmet = sum(not each.met for each in outcome.criteria)
        met = f"{len(outcome.criteria) - unmet} / {len(outcome.criteria)}"
        rows.append((problem.title, met, f"{unmet} not met" if unmet else "✓", round(outcome.seconds, 1)))
    return Section(
        "summary", "In short", (Table("In short", ("problem", "criteria met", "", "time [s]"), tuple(rows)),)
    )


def _problem(problem: Problem, outcome: Outcome) -> Section:
    verdicts = [Verdict(AGREE if each.met else APART, criterion_text(each)) for each in outcome.criteria]
    return Section(
        problem.name,
        problem.title,
        tuple(each for each in outcome.tables if each.rows),
        tuple(outcome.plots),
        tuple(outcome.remarks),
        lead=f"{problem.description} Source: {problem.source}.",
        pictures=tuple(outcome.pictures),
        verdicts=tuple(sorted(verdicts, key=lambda verdict: verdict.kind == AGREE)),
    )

"""Criteria and outcomes as plain text."""

import math

from studies.report.study_text import shown
from studies.verification.outcome import Criterion, Outcome
from studies.verification.problem import Problem


def outcome_text(problem: Problem, outcome: Outcome) -> str:
    """How many criteria of a problem are met, and those that are not."""
    met = sum(criterion.met for criterion in outcome.criteria)
    lines = [f"{problem.name}: {met} of {len(outcome.criteria)} criteria met, {outcome.seconds:.1f} s"]
    lines += [f"  not met: {criterion_text(each)}" for each in outcome.criteria if not each.met]
    return "\n".join(lines)


def criterion_text(criterion: Criterion) -> str:
    """What was asked, what was found and, if it is so, why nothing was."""
    if criterion.value is None:
        return f"{criterion.what}: not measured: {criterion.reason}"
    unit = f" {criterion.unit}" if criterion.unit else ""
    return f"{criterion.what}: {shown(criterion.value)}{unit} (wanted {_wanted(criterion)}{unit})"


def _wanted(criterion: Criterion) -> str:
    low, high = shown(criterion.low), shown(criterion.high)
    if math.isinf(criterion.low):
        return f"at most {high}"
    return f"at least {low}" if math.isinf(criterion.high) else f"{low} to {high}"

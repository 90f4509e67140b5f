"""How far two methods are apart in one quantity, and whether their extrapolated values agree."""

from dataclasses import dataclass
from math import hypot

from studies.comparisons.convergence import Estimate
from studies.methods.method import find_method
from studies.output.display import plus_minus, shown_title, shown_unit, with_unit
from studies.runs.result import RunResult

TELLING = 0.1  # an uncertainty beyond this share of the value is no basis for a verdict
CLOSE = 0.01  # uncertainty by the value, above which to agree within it says little


@dataclass(frozen=True)
class Difference:
    """Second minus first, of the finest runs and of the limits; relative to the first.

    uncertainty: of the difference of the limits; agree: whether that difference lies within it (None: no
    verdict is possible); loosely: whether they agree within an uncertainty of more than CLOSE of the
    value; verdict: the same as a sentence.
    """

    quantity: str
    unit: str
    first: str
    second: str
    finest: float
    finest_relative: float | None
    limit: float
    limit_relative: float | None
    uncertainty: float | None
    agree: bool | None
    loosely: bool
    verdict: str


def difference(
    name: str, first: RunResult, second: RunResult, limits: dict[str, dict[str, Estimate]]
) -> Difference:
    """Compare one quantity of two finest runs and of the limits of their methods."""
    unit = first.quantities[name].unit
    values = first.quantities[name].value, second.quantities[name].value
    estimates = limits[first.method][name], limits[second.method][name]
    gap = estimates[1].value - estimates[0].value
    uncertainty = _combined(*estimates)
    agree = _agreement(gap, uncertainty, estimates[0].value)
    return Difference(
        quantity=name,
        unit=unit,
        first=first.label,
        second=second.label,
        finest=values[1] - values[0],
        finest_relative=_relative(values[1] - values[0], values[0]),
        limit=gap,
        limit_relative=_relative(gap, estimates[0].value),
        uncertainty=uncertainty,
        agree=agree,
        loosely=_is_loose(agree, uncertainty, estimates[0].value),
        verdict=verdict_text(
            name, unit, tuple(find_method(run.method).label for run in (first, second)), estimates
        ),
    )


def _combined(first: Estimate, second: Estimate) -> float | None:
    if first.uncertainty is None or second.uncertainty is None:
        return None
    return hypot(first.uncertainty, second.uncertainty)


def _agreement(gap: float, uncertainty: float | None, value: float) -> bool | None:
    if uncertainty is None or uncertainty > TELLING * abs(value):
        return None
    return abs(gap) <= uncertainty


def _is_loose(agree: bool | None, uncertainty: float | None, value: float) -> bool:
    return agree is True and uncertainty > CLOSE * abs(value)


def _relative(gap: float, base: float) -> float | None:
    return gap / abs(base) if base else None


def verdict_text(name: str, unit: str, labels: tuple[str, str], estimates: tuple[Estimate, Estimate]) -> str:
    """A sentence: what two methods, by their labels, tend to, and whether these limits agree."""
    first, second = estimates
    told = [_told(label, estimate, unit) for label, estimate in zip(labels, estimates, strict=True)]
    gap = second.value - first.value
    uncertainty = _combined(first, second)
    agree = _agreement(gap, uncertainty, first.value)
    by = with_unit(abs(gap), unit, 3)
    relative = _relative(abs(gap), first.value)
    if relative is not None:
        by += f", {100.0 * relative:.2g} %"
    subject = f"{shown_title(name)}: {told[0]} and {told[1]}"
    agreement = f"{subject} agree within their uncertainty (apart by {by})"
    if uncertainty is None:
        return f"{subject} differ by {by}; one resolution does not tell their errors."
    if agree is None:
        return f"{subject} are apart by {by}; not converged well enough for a verdict."
    if _is_loose(agree, uncertainty, first.value):
        only = "only because " * (abs(gap) > CLOSE * abs(first.value))
        agreement += f", but {only}{_doubts(labels, estimates)}"
    if agree:
        return f"{agreement}."
    return f"{subject} differ by {by}, more than their uncertainty ({with_unit(uncertainty, unit, 2)})."


def _doubts(labels: tuple[str, str], estimates: tuple[Estimate, Estimate]) -> str:
    """Which of them is uncertain by more than is close, or both, and by how much."""
    shares = {
        label: each.uncertainty / abs(each.value) for label, each in zip(labels, estimates, strict=True)
    }
    wide = {label: share for label, share in shares.items() if share > CLOSE} or shares
    return " and ".join(f"{label} is uncertain by {100.0 * share:.2g} %" for label, share in wide.items())


def _told(label: str, estimate: Estimate, unit: str) -> str:
    number = plus_minus(estimate.value, estimate.uncertainty, unit)
    return f"{label} {number} {shown_unit(unit)}".rstrip()

"""Our values next to values from elsewhere."""

from dataclasses import dataclass

from studies.comparisons.convergence import Estimate
from studies.runs.result import RunResult
from studies.scenes.scene import Reference, Scene


@dataclass(frozen=True)
class ReferenceCheck:
    """One reference and one run: how far the run's value and its method's limit lie outside low..high.

    Zero inside the range. Relative to the nearer end.
    """

    reference: Reference
    run: str
    value: float
    unit: str
    outside: float
    outside_relative: float
    limit: float
    limit_outside: float


def check_references(
    finest: list[RunResult], limits: dict[str, dict[str, Estimate]], scene: Scene, wall: str
) -> list[ReferenceCheck]:
    """Every reference that holds for this wall, against the finest run of every method."""
    holding = [reference for reference in scene.references if reference.wall in (None, wall)]
    return [
        _check(reference, run, limits[run.method][reference.quantity])
        for reference in holding
        for run in finest
        if reference.quantity in limits[run.method]
    ]


def _check(reference: Reference, run: RunResult, limit: Estimate) -> ReferenceCheck:
    quantity = run.quantities[reference.quantity]
    outside = _outside(quantity.value, reference)
    end = reference.high if outside > 0.0 else reference.low
    return ReferenceCheck(
        reference=reference,
        run=run.label,
        value=quantity.value,
        unit=quantity.unit,
        outside=outside,
        outside_relative=outside / end,
        limit=limit.value,
        limit_outside=_outside(limit.value, reference),
    )


def _outside(value: float, reference: Reference) -> float:
    return value - min(max(value, reference.low), reference.high)

"""The true limit of a variant's step, by bisection, as a ratio to the estimate that its solver makes."""

from collections.abc import Callable
from typing import Any

from core_models.errors import RunFailure
from studies.stability.case import LARGEST_DRIFT
from studies.stability.cases.elastic import CAUTIOUS, ringing
from studies.stability.cell import energy_drift

STEPS = 2000  # in which an instability of the elastic bar shows
BISECTIONS = 8
LOOK = 20  # steps between looks
HIGHEST = 4.0  # times the estimate; a limit above it is not looked for


def true_limit(variant: str, build: Callable[..., Any] = ringing) -> float:
    """Largest stable step over the estimated limit, both of an elastic bar that swings, to 2 %; at most HIGHEST.

    The estimate is what the solver takes, over its own share of it (`safety`, `cfl`).
    """
    low, high = 0.0, HIGHEST
    if _is_stable(variant, high, build):
        return high
    for _ in range(BISECTIONS):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if _is_stable(variant, middle, build) else (low, middle)
    return low


def _is_stable(variant: str, ratio: float, build: Callable[..., Any]) -> bool:
    solver = build(variant, **{CAUTIOUS[variant.partition(":")[0]]: 1.0})
    try:
        for step in range(STEPS):
            solver.time_step *= ratio
            solver.advance()
            if step % LOOK == 0 and not _swings_on(solver):
                return False
    except RunFailure:
        return False
    return _swings_on(solver)


def _swings_on(solver: Any) -> bool:
    """Whether the energy holds, and is no more than at the start: an error relative to what has grown may be small."""
    ledger = solver.ledger
    has_grown = not ledger.kinetic + ledger.strain <= (1.0 + LARGEST_DRIFT) * ledger.initial
    return energy_drift(solver) <= LARGEST_DRIFT and not has_grown

"""The policy for steps that go wrong: redo smaller a few times, then give up with a typed error."""

import logging
from collections.abc import Callable

from core_models.errors import RunFailure, SceneError
from core_models.points import PointFailure

logger = logging.getLogger(__name__)

MAXIMUM_REDOS = 6
REDUCTION = 0.25
ADVICE = "check velocity and material, or try another resolution"
VANISHING_STEP = 1e-6  # of the first step's size: below it a run would not come to an end


def redoing(
    attempt, dt: float, smallest: float, place: Callable[[], str], explain: Callable, advice: str = ADVICE
) -> float:
    """Call attempt(dt) until it does not raise PointFailure, each time with a quarter of the step.

    Parameters
    ----------
    attempt : takes dt [s]; must leave everything as it was when it raises. smallest : step not to go below [s].
    place : says step, time, point and laws, for the message about a vanishing step. explain : turns the last
    PointFailure into the RunFailure that ends the run. advice : what to do about a vanishing step.

    Returns the step that worked [s].
    """
    for redo in range(MAXIMUM_REDOS + 1):
        if not dt > smallest:
            raise RunFailure(
                f"{place()}: the time step has shrunk to {dt:.3e} s: something moves, or is squeezed, too fast for "
                f"this resolution; {advice}"
            )
        try:
            attempt(dt)
            return dt
        except PointFailure as reason:
            failure = reason
            logger.info("step of %.3e s redone (%d): %s at point %d", dt, redo + 1, reason, reason.point)
            dt *= REDUCTION
    raise explain(failure)


def step_within(dt: float, remaining: float) -> float:
    """The step to take, not beyond `remaining` [s]: the last two steps are alike, so that none is next to nothing.

    Raises SceneError where nothing remains.
    """
    if not remaining > 0.0:
        raise SceneError(f"advance: the limit is {remaining:g} s after the present time: give a later one")
    if remaining <= dt:
        return remaining
    return min(dt, 0.5 * remaining)

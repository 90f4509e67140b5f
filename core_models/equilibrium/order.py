"""The order at which Newton's method has converged, from its log."""

import math
from itertools import groupby

from core_models.equilibrium.log import ConvergenceLog, Iteration

ROUND_OFF = 1e-11  # of the norm, relative to the largest of an attempt
FLOOR = 1e3 * ROUND_OFF


def newton_orders(log: ConvergenceLog) -> list[float]:
    """Orders log(n3 / n2) / log(n2 / n1) of all attempts that qualify.

    n = (r . K^-1 r)^(1/2), the energy norm of the residual r: unlike a sum of squared forces it does not mix stiff and
    soft motions, of which Newton's method takes out the stiff ones first. n1, n2, n3 are the last three above 1000
    times round-off. An attempt qualifies if it has three such, that of its guess not counted, that whole corrections
    have led to without changing which points flow: where that has changed a residual is no remainder of second order.
    """
    attempts = groupby(log.iterations, key=lambda each: (each.increment, each.attempt))
    found = (_order(list(group)) for _key, group in attempts)
    return [order for order in found if order is not None]


def _order(iterations: list[Iteration]) -> float | None:
    # The energy of a correction, recorded where it has led, is that of the residual before.
    pairs = list(zip(iterations[1:], iterations[2:], strict=False))
    norms = [(math.sqrt(after.energy), before) for before, after in pairs]
    floor = FLOOR * max((norm for norm, _at in norms), default=0.0)
    last = [(norm, at) for norm, at in norms if norm > floor][-3:]
    if len(last) < 3 or not all(at.same and at.length == 1.0 for _norm, at in last):
        return None
    first, second, third = (norm for norm, _at in last)
    return math.log(third / second) / math.log(second / first) if third < second < first else None

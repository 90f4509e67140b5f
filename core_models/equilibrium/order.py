"""The order at which Newton's method has converged, from its log."""

import math
import sys
from itertools import groupby

from core_models.equilibrium.log import ConvergenceLog, Iteration

FLOOR = 1e3 * sys.float_info.epsilon  # of the relative residual: below it round-off has its say


def newton_orders(log: ConvergenceLog) -> list[float]:
    """Orders log(r3 / r2) / log(r2 / r1) of all attempts that qualify.

    r1, r2, r3 : the last three residuals above 1000 times the round-off of the forces. An attempt qualifies if it has
    three such, from whole corrections, and if the points that flow are the same in all three.
    """
    attempts = groupby(log.iterations, key=lambda each: (each.increment, each.attempt))
    found = (_order([each for each in group if each.relative > FLOOR]) for _key, group in attempts)
    return [order for order in found if order is not None]


def _order(iterations: list[Iteration]) -> float | None:
    last = iterations[-3:]
    if len(last) < 3 or not all(each.same and each.length == 1.0 for each in last[1:]):
        return None
    first, second, third = (each.residual for each in last)
    if not third < second < first:
        return None
    return math.log(third / second) / math.log(second / first)

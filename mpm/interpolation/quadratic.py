"""Quadratic B-splines: three nodes along an axis, continuous slopes."""

import math
from typing import NamedTuple

from mpm.interpolation import layers, locate, middle, moments, reach, row, slopes, spread, weights
from mpm.lanes import lanes


class QuadraticSpline(NamedTuple):
    """Quadratic B-splines; t in [-1/2, 1/2] is counted from the middle node.

    Source: Steffen, Kirby & Berzins, Int. J. Numer. Meth. Eng. 76 (2008) 922.
    """


@reach.register(QuadraticSpline)
def _(shape):
    return 3


@middle.register(QuadraticSpline)
def _(shape):
    return 1.0


@layers.register(QuadraticSpline)
def _(shape):
    return 1


@locate.register(QuadraticSpline)
def _(shape, x):
    cell = math.floor(x)
    return cell - 1.0, x - cell - 0.5


@weights.register(QuadraticSpline)
def _(shape, t, half):
    low, high = 0.5 - t, 0.5 + t
    return 0.5 * low * low, 0.75 - t * t, 0.5 * high * high


@slopes.register(QuadraticSpline)
def _(shape, t, half):
    return t - 0.5, -2.0 * t, t + 0.5


@spread.register(QuadraticSpline)
def _(shape, t, half):
    return lanes(0.25, 0.25, 0.25, 0.0)


@moments.register(QuadraticSpline)
def _(shape, t, half):
    low, high = 0.5 - t, 0.5 + t
    return -2.0 * (1.0 + t) * low * low, -4.0 * t * (0.75 - t * t), 2.0 * (1.0 - t) * high * high


@row.register(QuadraticSpline)
def _(shape, table, place):
    return table[place], table[place + 4], table[place + 8]

"""Cubic B-splines: four nodes along an axis, continuous curvature."""

import math
from typing import NamedTuple

from mpm.interpolation import layers, locate, middle, moments, reach, row, slopes, spread, weights
from mpm.lanes import lanes

SIXTH, THIRD = 1.0 / 6.0, 1.0 / 3.0


class CubicSpline(NamedTuple):
    """Cubic B-splines; t in [0, 1) is counted from the second node.

    Source: Steffen, Kirby & Berzins, Int. J. Numer. Meth. Eng. 76 (2008) 922.
    """


@reach.register(CubicSpline)
def _(shape):
    return 4


@middle.register(CubicSpline)
def _(shape):
    return 1.0


@layers.register(CubicSpline)
def _(shape):
    return 2


@locate.register(CubicSpline)
def _(shape, x):
    lower = math.floor(x - 0.5)
    return lower - 1.0, x - 0.5 - lower


@weights.register(CubicSpline)
def _(shape, t, half):
    s = 1.0 - t
    return (
        SIXTH * s * s * s,
        2.0 * THIRD - t * t * (1.0 - 0.5 * t),
        2.0 * THIRD - s * s * (1.0 - 0.5 * s),
        SIXTH * t * t * t,
    )


@slopes.register(CubicSpline)
def _(shape, t, half):
    s = 1.0 - t
    return -0.5 * s * s, t * (1.5 * t - 2.0), s * (2.0 - 1.5 * s), 0.5 * t * t


@spread.register(CubicSpline)
def _(shape, t, half):
    return lanes(THIRD, THIRD, THIRD, 0.0)


@moments.register(CubicSpline)
def _(shape, t, half):
    w = weights(shape, t, half)
    return (
        -3.0 * (1.0 + t) * w[0],
        -3.0 * t * w[1],
        3.0 * (1.0 - t) * w[2],
        3.0 * (2.0 - t) * w[3],
    )


@row.register(CubicSpline)
def _(shape, table, place):
    return table[place], table[place + 4], table[place + 8], table[place + 12]

"""Linear interpolation: two nodes along an axis. Slopes jump between cells, which particles feel when they cross."""

import math
from typing import NamedTuple

from mpm.interpolation import layers, locate, middle, moments, reach, row, slopes, spread, weights
from mpm.lanes import lanes


class LinearHat(NamedTuple):
    """Linear (tent) functions; t in [0, 1) is counted from the lower node."""


@reach.register(LinearHat)
def _(shape):
    return 2


@middle.register(LinearHat)
def _(shape):
    return 0.0


@layers.register(LinearHat)
def _(shape):
    return 1


@locate.register(LinearHat)
def _(shape, x):
    first = math.floor(x - 0.5)
    return first + 0.0, x - 0.5 - first


@weights.register(LinearHat)
def _(shape, t, half):
    return 1.0 - t, t


@slopes.register(LinearHat)
def _(shape, t, half):
    one = lanes(1.0, 1.0, 1.0, 1.0)
    return -1.0 * one, one


@spread.register(LinearHat)
def _(shape, t, half):
    return t * (1.0 - t)


@moments.register(LinearHat)
def _(shape, t, half):
    # D cancels against the weights: the quotient stays finite where D is 0, on the nodes.
    return slopes(shape, t, half)


@row.register(LinearHat)
def _(shape, table, place):
    return table[place], table[place + 4]

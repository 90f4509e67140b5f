"""Uniform generalised interpolation (uGIMP): tent functions averaged over each particle's undeformed size."""

import math
from typing import NamedTuple

import numpy as np

from core_models.compilation import inside_kernel
from mpm.interpolation import half_size, layers, locate, middle, moments, reach, row, slopes, spread, weights
from mpm.lanes import lanes, maximum, minimum


class UniformGimp(NamedTuple):
    """The tent function's mean over [x - l, x + l]; t in [-1/2, 1/2] is counted from the middle node.

    halves : (n, d) half sizes l of the particles [m], at most half a cell; they do not follow the deformation.
    Source: Bardenhagen & Kober, Comput. Model. Eng. Sci. 5 (2004) 477.
    """

    halves: np.ndarray


@inside_kernel
def tent(x):
    """Tent function of width 2."""
    return 1.0 - minimum(maximum(x, 0.0 - x), 1.0)


@inside_kernel
def integral_of_tent(x):
    """Integral of the tent function from 0 to x."""
    x = minimum(maximum(x, -1.0), 1.0)
    return x * (1.0 - 0.5 * maximum(x, 0.0 - x))


@inside_kernel
def mean_of_tent(x, half):
    """Mean of the tent function over [x - half, x + half]."""
    return (integral_of_tent(x + half) - integral_of_tent(x - half)) / (2.0 * half)


@inside_kernel
def slope_of_mean(x, half):
    """Derivative of that mean."""
    return (tent(x + half) - tent(x - half)) / (2.0 * half)


@reach.register(UniformGimp)
def _(shape):
    return 3


@middle.register(UniformGimp)
def _(shape):
    return 1.0


@layers.register(UniformGimp)
def _(shape):
    return 1


@locate.register(UniformGimp)
def _(shape, x):
    cell = math.floor(x)
    return cell - 1.0, x - cell - 0.5


@half_size.register(UniformGimp)
def _(shape, p, over_h):
    halves = shape.halves
    depth = halves[p, 2] if halves.shape[1] == 3 else halves[p, 1]
    return over_h * lanes(halves[p, 0], halves[p, 1], depth, 1.0)


@weights.register(UniformGimp)
def _(shape, t, half):
    return mean_of_tent(t + 1.0, half), mean_of_tent(t, half), mean_of_tent(t - 1.0, half)


@slopes.register(UniformGimp)
def _(shape, t, half):
    return slope_of_mean(t + 1.0, half), slope_of_mean(t, half), slope_of_mean(t - 1.0, half)


@spread.register(UniformGimp)
def _(shape, t, half):
    low, high = t + 1.0, t - 1.0
    return (
        mean_of_tent(low, half) * low * low
        + mean_of_tent(t, half) * t * t
        + mean_of_tent(high, half) * high * high
    )


@moments.register(UniformGimp)
def _(shape, t, half):
    w = weights(shape, t, half)
    over = 1.0 / spread(shape, t, half)
    return over * w[0] * (-1.0 - t), over * w[1] * (0.0 - t), over * w[2] * (1.0 - t)


@row.register(UniformGimp)
def _(shape, table, place):
    return table[place], table[place + 4], table[place + 8]

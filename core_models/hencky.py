"""Logarithm of a symmetric tensor from its principal values and axes, and what it does as the tensor changes."""

import math

from core_models.compilation import inside_kernel
from core_models.elementary import logarithm
from core_models.tensors import congruence, determinant, transposed

CLOSE = 1e-5  # relative distance of principal values below which a series gives their divided difference


@inside_kernel
def logarithm_along(values, axes):
    """Logarithm of the symmetric tensor with these principal values, > 0, and axes."""
    return congruence(axes, (logarithm(values[0]), logarithm(values[1]), logarithm(values[2]), 0.0, 0.0, 0.0))


@inside_kernel
def logarithm_change(values, axes, change):
    """Derivative of the logarithm in the direction of a symmetric tensor (Daleckii and Krein)."""
    c = congruence(transposed(axes), change)
    x, y, z = values
    return congruence(
        axes,
        (
            c[0] / x, c[1] / y, c[2] / z, c[3] * mean_slope(x, y), c[4] * mean_slope(y, z), c[5] * mean_slope(z, x),
        ),
    )  # fmt: skip


@inside_kernel
def mean_slope(x, y):
    """Divided difference (ln x - ln y) / (x - y)."""
    e = (x - y) / y
    if abs(e) < CLOSE:
        return (1.0 - e * (0.5 - e * (1.0 / 3.0))) / y
    return math.log1p(e) / (x - y)


@inside_kernel
def along(axes, vector):
    """An axial vector with components along the axes, which may be a left-handed frame, in the frame of these."""
    hand = determinant(axes)
    return (
        hand * (axes[0] * vector[0] + axes[1] * vector[1] + axes[2] * vector[2]),
        hand * (axes[3] * vector[0] + axes[4] * vector[1] + axes[5] * vector[2]),
        hand * (axes[6] * vector[0] + axes[7] * vector[1] + axes[8] * vector[2]),
    )

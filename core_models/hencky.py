"""Principal values and axes of a symmetric tensor, its logarithm, and what the logarithm does as the tensor changes."""

import math

from core_models.compilation import beside_kernel, inside_kernel
from core_models.elementary import logarithm
from core_models.tensors import IDENTITY, congruence, product, trace, transposed

SWEEPS = 12  # of Jacobi's rotations; the off-diagonal part is squared by each
NEGLIGIBLE = 1e-36  # square of the off-diagonal part, relative to that of the trace
CLOSE = 1e-5  # relative distance of principal values below which a series gives their divided difference


@beside_kernel
def principal_axes(s):
    """Principal values (three) of a positive definite tensor and its axes, the columns of a rotation (nine)."""
    axes, limit = IDENTITY, NEGLIGIBLE * trace(s) * trace(s)
    for _sweep in range(SWEEPS):
        if s[3] * s[3] + s[4] * s[4] + s[5] * s[5] <= limit:
            break
        c, n = plane_rotation(s[0], s[1], s[3])
        turn = (c, -n, 0.0, n, c, 0.0, 0.0, 0.0, 1.0)
        s, axes = congruence(transposed(turn), s), product(axes, turn)
        c, n = plane_rotation(s[1], s[2], s[4])
        turn = (1.0, 0.0, 0.0, 0.0, c, -n, 0.0, n, c)
        s, axes = congruence(transposed(turn), s), product(axes, turn)
        c, n = plane_rotation(s[0], s[2], s[5])
        turn = (c, 0.0, -n, 0.0, 1.0, 0.0, n, 0.0, c)
        s, axes = congruence(transposed(turn), s), product(axes, turn)
    return (s[0], s[1], s[2]), axes


@inside_kernel
def plane_rotation(first, second, shear):
    """Cosine and sine of the smaller rotation in a plane that takes its shear component to zero."""
    if shear == 0.0:
        return 1.0, 0.0
    half_cotangent = 0.5 * (first - second) / shear
    tangent = math.copysign(
        1.0 / (abs(half_cotangent) + math.sqrt(1.0 + half_cotangent * half_cotangent)), half_cotangent
    )
    c = 1.0 / math.sqrt(1.0 + tangent * tangent)
    return c, c * tangent


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
    """A vector with components along the axes, in the frame of these."""
    return (
        axes[0] * vector[0] + axes[1] * vector[1] + axes[2] * vector[2],
        axes[3] * vector[0] + axes[4] * vector[1] + axes[5] * vector[2],
        axes[6] * vector[0] + axes[7] * vector[1] + axes[8] * vector[2],
    )

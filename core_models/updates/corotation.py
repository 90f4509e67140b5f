"""The frame in which the hypoelastic update integrates: that of an objective rate, seen from the frame turned by R."""

from core_models.compilation import inside_kernel
from core_models.dispatch import generic
from core_models.quaternions import rotation_matrix, turned
from core_models.rotation import slightly_turned, turning
from core_models.tensors import (
    congruence,
    full,
    minus,
    plus,
    product,
    scaled,
    symmetric_inverse,
    symmetric_part,
    symmetric_part_of_product,
)


@generic
def corotated(objective_rate, before, after, increment):
    """Strain increment of a step and the rotation of the stress in it.

    Parameters
    ----------
    objective_rate : the law; None is Green and Naghdi's rate. before, after : stretches V_0 and U of the step (six
    components), in the frame before it. increment : quaternion of Q = R_1 R_0^T.

    Returns
    -------
    strain increment d (six components) in the frame before the step, and the quaternion of the rotation of the
    rate's frame
    """


@corotated.register(type(None))
def _(objective_rate, before, after, increment):
    return stretching(before, after), increment


@generic
def corotated_change(objective_rate, before, after, over_sum, change, spin):
    """Derivatives of what `corotated` returns.

    Parameters
    ----------
    over_sum : (U + V_0)^-1. change : dU. spin : vector w of dQ = Q [w].

    Returns
    -------
    derivative of the strain increment, vector of the spin of the rate's frame
    """


@corotated_change.register(type(None))
def _(objective_rate, before, after, over_sum, change, spin):
    return symmetric_part(gradient_change(before, over_sum, change)), spin


@inside_kernel
def stretching(before, after):
    """Unrotated rate of deformation times dt at mid-step, d = sym[2 (U - V_0) (U + V_0)^-1]."""
    return scaled(
        symmetric_part_of_product(minus(after, before), symmetric_inverse(plus(after, before))), 2.0
    )


@inside_kernel
def stretch_gradient(before, after):
    """The tensor 2 (U - V_0) (U + V_0)^-1 itself: its symmetric part is the strain, its other the spin of material."""
    return product(full(scaled(minus(after, before), 2.0)), full(symmetric_inverse(plus(after, before))))


@inside_kernel
def gradient_change(before, over_sum, change):
    """Derivative of `stretch_gradient`: 4 V_0 (U + V_0)^-1 dU (U + V_0)^-1."""
    return product(full(scaled(before, 4.0)), full(congruence(full(over_sum), change)))


@inside_kernel
def half_turned(spin, increment):
    """Rotation tensor of half a spin (vector) of the step, and the quaternion of Q followed after the whole of it."""
    half = turning((0.5 * spin[0], 0.5 * spin[1], 0.5 * spin[2]))
    return rotation_matrix(half), turned(increment, turned(half, half))


@inside_kernel
def back(turn, v):
    """Vector R^T v."""
    return (
        turn[0] * v[0] + turn[3] * v[1] + turn[6] * v[2],
        turn[1] * v[0] + turn[4] * v[1] + turn[7] * v[2],
        turn[2] * v[0] + turn[5] * v[1] + turn[8] * v[2],
    )


@inside_kernel
def forth(turn, v):
    """Vector R v."""
    return (
        turn[0] * v[0] + turn[1] * v[1] + turn[2] * v[2],
        turn[3] * v[0] + turn[4] * v[1] + turn[5] * v[2],
        turn[6] * v[0] + turn[7] * v[1] + turn[8] * v[2],
    )


@inside_kernel
def half_spin(spin, change):
    """Vector w of dH = H [w] for the rotation H of `half_turned` as the spin changes."""
    x, y, z = 0.25 * spin[0], 0.25 * spin[1], 0.25 * spin[2]
    a, b, c = 0.25 * change[0], 0.25 * change[1], 0.25 * change[2]
    h = 2.0 / (1.0 + (x * x + y * y + z * z))
    return (h * (a - (y * c - z * b)), h * (b - (z * a - x * c)), h * (c - (x * b - y * a)))


@inside_kernel
def whole_spin(turn, spin, half):
    """Spin of Q H H: that of Q seen from the turned frame, and twice that of H."""
    x = back(turn, spin)
    y = back(turn, (x[0] + half[0], x[1] + half[1], x[2] + half[2]))
    return (y[0] + half[0], y[1] + half[1], y[2] + half[2])


@inside_kernel
def turned_back(s, spin):
    """Change of the symmetric tensor s = R^T t R as R turns with dR = R [w] and t stays."""
    return scaled(minus(slightly_turned(s, spin), s), 2.0)

"""Incremental update of the rotation R and the left stretch V in F = V R (Flanagan & Taylor 1987).

No polar decomposition is made: the rotation of the step before is turned by the increment that makes V symmetric,

    (tr V 1 - V) w = axial(A - A^T),   A = F R^T,

which is Flanagan and Taylor's equation for the spin of the stretch's axes, applied to the finite step and repeated
until A is symmetric to round-off (once or twice in an explicit step). V and R therefore never drift away from F.
Source: Flanagan & Taylor, Comput. Methods Appl. Mech. Eng. 62 (1987) 305, eqs. 13-17.
"""

import math

from core_models.compilation import beside_kernel, inside_kernel
from core_models.tensors import (
    IDENTITY,
    determinant,
    inverse,
    product,
    product_transposed,
    symmetric_inverse,
    symmetric_part,
)

SYMMETRY_TOLERANCE = 1e-13  # of |A - A^T| relative to tr V; round-off of A itself is some 1e-16
MAXIMUM_INCREMENTS = 12
LARGE_ROTATION = 0.75  # of tr(A)^2 / |A|^2: below it the step turns by some 75 degrees or more


@inside_kernel
def cayley_rotation(wx, wy, wz):
    """Rotation about the vector w by the angle 2 atan(|w|/2): Q = 1 + (W + W^2/2) / (1 + |w|^2/4)."""
    xx, yy, zz = wx * wx, wy * wy, wz * wz
    g = 1.0 / (1.0 + 0.25 * (xx + yy + zz))
    h = 0.5 * g
    return (
        1.0 - h * (yy + zz), h * wx * wy - g * wz, h * wx * wz + g * wy,
        h * wx * wy + g * wz, 1.0 - h * (xx + zz), h * wy * wz - g * wx,
        h * wx * wz - g * wy, h * wy * wz + g * wx, 1.0 - h * (xx + yy),
    )  # fmt: skip


@inside_kernel
def polar_rotation(f):
    """Rotation of f = V R by Higham's iteration; for increments too large for the incremental update."""
    for _ in range(60):
        g = inverse(f, determinant(f))
        n = (
            0.5 * (f[0] + g[0]), 0.5 * (f[1] + g[3]), 0.5 * (f[2] + g[6]),
            0.5 * (f[3] + g[1]), 0.5 * (f[4] + g[4]), 0.5 * (f[5] + g[7]),
            0.5 * (f[6] + g[2]), 0.5 * (f[7] + g[5]), 0.5 * (f[8] + g[8]),
        )  # fmt: skip
        change = 0.0
        for k in range(9):
            change = max(change, abs(n[k] - f[k]))
        f = n
        if change < 1e-15:
            break
    return f


@inside_kernel
def planar_increment(a):
    """Increment and stretch of a = V Q about the third axis, in closed form: tan(angle) = (a21 - a12) / (a11 + a22)."""
    c, s = a[0] + a[4], a[3] - a[1]
    h = 1.0 / math.sqrt(c * c + s * s)
    c, s = c * h, s * h
    q = (c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0)
    return q, (a[0] * c - a[1] * s, a[3] * s + a[4] * c, a[8], a[0] * s + a[1] * c, 0.0, 0.0)


@inside_kernel
def asymmetry_solver(a):
    """Inverse of tr V 1 - V for V = sym(a)."""
    return symmetric_inverse(
        (
            a[4] + a[8], a[0] + a[8], a[0] + a[4],
            -0.5 * (a[1] + a[3]), -0.5 * (a[5] + a[7]), -0.5 * (a[2] + a[6]),
        )
    )  # fmt: skip


@inside_kernel
def symmetrising_rotation(g, x, y, z):
    """Rotation that removes the asymmetry (x, y, z), to first order."""
    return cayley_rotation(
        g[0] * x + g[3] * y + g[5] * z,
        g[3] * x + g[1] * y + g[4] * z,
        g[5] * x + g[4] * y + g[2] * z,
    )


@inside_kernel
def turns_far(a):
    """Whether a step turns by some 75 degrees or more, too far for the incremental update."""
    squares = 0.0
    for component in a:
        squares += component * component
    diagonal = a[0] + a[4] + a[8]
    return diagonal <= 0.0 or diagonal * diagonal < LARGE_ROTATION * squares


@inside_kernel
def small_rotation_increment(f, rotation):
    """The same as `rotation_increment` in a straight line of two increments, for the rotation of an explicit step.

    Returns
    -------
    Q, V and whether they are right.
    """
    a = product_transposed(f, rotation)
    limit = SYMMETRY_TOLERANCE * (a[0] + a[4] + a[8])
    is_small = not turns_far(a)
    first = symmetrising_rotation(asymmetry_solver(a), a[7] - a[5], a[2] - a[6], a[3] - a[1])
    a = product_transposed(a, first)
    second = symmetrising_rotation(asymmetry_solver(a), a[7] - a[5], a[2] - a[6], a[3] - a[1])
    a = product_transposed(a, second)
    v = symmetric_part(a)
    is_symmetric = abs(a[7] - a[5]) + abs(a[2] - a[6]) + abs(a[3] - a[1]) <= limit
    is_definite = v[0] > 0.0 and v[0] * v[1] > v[3] * v[3]
    return product(second, first), v, is_small and is_symmetric and is_definite


@beside_kernel
def rotation_increment(f, rotation):
    """Increment Q of the rotation and new left stretch V: f = V (Q rotation).

    Parameters
    ----------
    f : deformation gradient after the step, det f > 0.
    rotation : rotation before the step.

    Returns
    -------
    Q : rotation increment; V : left stretch (six components).
    """
    a = product_transposed(f, rotation)
    if a[2] == 0.0 and a[5] == 0.0 and a[6] == 0.0 and a[7] == 0.0:
        return planar_increment(a)
    if turns_far(a):
        q = polar_rotation(a)
        return q, symmetric_part(product_transposed(a, q))
    q = IDENTITY
    solver = asymmetry_solver(a)
    limit = SYMMETRY_TOLERANCE * (a[0] + a[4] + a[8])
    for increment in range(MAXIMUM_INCREMENTS):
        x, y, z = a[7] - a[5], a[2] - a[6], a[3] - a[1]
        if abs(x) + abs(y) + abs(z) <= limit:
            break
        if increment > 2:
            solver = asymmetry_solver(a)
        step = symmetrising_rotation(solver, x, y, z)
        a = product_transposed(a, step)
        q = product(step, q) if increment > 0 else step
    v = symmetric_part(a)
    if v[0] > 0.0 and v[0] * v[1] > v[3] * v[3]:
        return q, v
    # A large stretch and a large rotation in one step: the increments have found another symmetric V.
    a = product_transposed(f, rotation)
    q = polar_rotation(a)
    return q, symmetric_part(product_transposed(a, q))

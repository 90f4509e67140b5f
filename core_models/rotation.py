"""Incremental update of the rotation R in F = V R (Flanagan & Taylor 1987).

No polar decomposition is made: the rotation of the step before is turned by the increment Q that makes U symmetric in

    A = F R^T = Q U,   (tr U 1 - U) w = axial(A - A^T),

which is Flanagan and Taylor's equation for the spin of the stretch's axes, applied to the finite step. With the
symmetric part of A for U it gives Q up to the third power of its angle, and a second time, on what is left of the
asymmetry, to round-off. R therefore never drifts away from F.
Source: Flanagan & Taylor, Comput. Methods Appl. Mech. Eng. 62 (1987) 305, eqs. 13-17.
"""

import math

from core_models.compilation import beside_kernel, inside_kernel
from core_models.quaternions import quaternion_of_matrix, rotation_matrix, turned
from core_models.tensors import (
    determinant,
    inverse,
    symmetric_inverse,
    symmetric_part,
    transposed_product,
)

NO_ROTATION = (1.0, 0.0, 0.0, 0.0)
SYMMETRY_TOLERANCE = 1e-13  # of |A - A^T| relative to tr U; round-off of A itself is some 1e-16
SMALL_SQUARE = 1e-13  # of an angle whose square is as good as 0
MAXIMUM_INCREMENTS = 12
LARGE_ROTATION = 0.75  # of tr(A)^2 / |A|^2: below it the step turns by some 75 degrees or more


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
    """Increment and stretch of a = Q U about the third axis, in closed form: tan(angle) = (a21 - a12) / (a11 + a22)."""
    c, s = a[0] + a[4], a[3] - a[1]
    h = 1.0 / math.sqrt(c * c + s * s)
    c, s = c * h, s * h
    q = (1.0 + c, 0.0, 0.0, s) if c > 0.0 else (s, 0.0, 0.0, 1.0 - c)
    return q, (c * a[0] + s * a[3], c * a[4] - s * a[1], a[8], c * a[1] + s * a[4], 0.0, 0.0)


@inside_kernel
def large_increment(a):
    """Increment and stretch of a = Q U by the polar decomposition."""
    q = quaternion_of_matrix(polar_rotation(a))
    return q, symmetric_part(transposed_product(rotation_matrix(q), a))


@inside_kernel
def asymmetry(a):
    """Axial vector of a - a^T."""
    return (a[7] - a[5], a[2] - a[6], a[3] - a[1])


@inside_kernel
def symmetrising_vector(a):
    """The vector w that turns a towards symmetry: by 2 atan(|w|/2), which is |w| to second order."""
    x, y, z = asymmetry(a)
    g = symmetric_inverse(
        (
            a[4] + a[8], a[0] + a[8], a[0] + a[4],
            -0.5 * (a[1] + a[3]), -0.5 * (a[5] + a[7]), -0.5 * (a[2] + a[6]),
        )
    )  # fmt: skip
    return (
        g[0] * x + g[3] * y + g[5] * z,
        g[3] * x + g[1] * y + g[4] * z,
        g[5] * x + g[4] * y + g[2] * z,
    )


@inside_kernel
def turning(w):
    """Quaternion of the rotation by 2 atan(|w|/2) about w."""
    return (1.0, 0.5 * w[0], 0.5 * w[1], 0.5 * w[2])


@inside_kernel
def is_definite(u):
    """Whether a symmetric tensor that has a positive determinant is positive definite."""
    return u[0] > 0.0 and u[0] * u[1] > u[3] * u[3]


@inside_kernel
def turns_far(a):
    """Whether a step turns by some 75 degrees or more, too far for the incremental update."""
    squares = 0.0
    for component in a:
        squares += component * component
    diagonal = a[0] + a[4] + a[8]
    return diagonal <= 0.0 or diagonal * diagonal < LARGE_ROTATION * squares


@inside_kernel
def slightly_turned(s, w):
    """Symmetric part of (1 + [w])^T s for a symmetric tensor s and a small w, to first order."""
    x, y, z = w
    return (
        s[0] + z * s[3] - y * s[5],
        s[1] + x * s[4] - z * s[3],
        s[2] + y * s[5] - x * s[4],
        s[3] + 0.5 * (x * s[5] - y * s[4] + z * (s[1] - s[0])),
        s[4] + 0.5 * (y * s[3] - z * s[5] + x * (s[2] - s[1])),
        s[5] + 0.5 * (z * s[4] - x * s[3] + y * (s[0] - s[2])),
    )


@inside_kernel
def small_rotation_increment(a):
    """The same as `rotation_increment` in a straight line, for the rotation of an explicit step, up to half a degree.

    Returns
    -------
    Q, U and whether they are right.
    """
    first = turning(symmetrising_vector(a))
    rest = transposed_product(rotation_matrix(first), a)
    w = symmetrising_vector(rest)
    u = slightly_turned(symmetric_part(rest), w)
    is_small = w[0] * w[0] + w[1] * w[1] + w[2] * w[2] <= SMALL_SQUARE
    return turned(first, turning(w)), u, is_small and is_definite(u)


@beside_kernel
def rotation_increment(a):
    """Increment Q of the rotation and stretch U: a = Q U.

    Parameters
    ----------
    a : F R^T of the deformation gradient F after the step, det F > 0, and the rotation R before it.

    Returns
    -------
    Q : quaternion (core_models.quaternions); U : stretch seen in the frame before the step (six components).
    """
    if a[2] == 0.0 and a[5] == 0.0 and a[6] == 0.0 and a[7] == 0.0:
        return planar_increment(a)
    if turns_far(a):
        return large_increment(a)
    rest, q = a, NO_ROTATION
    limit = SYMMETRY_TOLERANCE * (a[0] + a[4] + a[8])
    for _increment in range(MAXIMUM_INCREMENTS):
        x, y, z = asymmetry(rest)
        if abs(x) + abs(y) + abs(z) <= limit:
            break
        step = turning(symmetrising_vector(rest))
        rest = transposed_product(rotation_matrix(step), rest)
        q = turned(q, step)
    u = symmetric_part(rest)
    if is_definite(u):
        return q, u
    # A large stretch and a large rotation in one step: the increments have found another symmetric U.
    return large_increment(a)

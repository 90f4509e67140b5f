"""Small tensor algebra on tuples, for use inside kernels.

A 3x3 tensor is a tuple of nine floats, row by row: (11, 12, 13, 21, 22, 23, 31, 32, 33). A symmetric tensor is a
tuple of six floats (11, 22, 33, 12, 23, 31): tensor components, no engineering shear. Tuples become registers in
compiled code, where arrays of nine would be allocated.
"""

import math

from core_models.compilation import inside_kernel

THIRD = 1.0 / 3.0
IDENTITY = (1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0)


@inside_kernel
def load_tensor(a, i):
    """Row i of an array (n, 3, 3) as a tensor."""
    return (
        a[i, 0, 0], a[i, 0, 1], a[i, 0, 2],
        a[i, 1, 0], a[i, 1, 1], a[i, 1, 2],
        a[i, 2, 0], a[i, 2, 1], a[i, 2, 2],
    )  # fmt: skip


@inside_kernel
def store_tensor(a, i, t):
    """Write tensor t in row i of an array (n, 3, 3)."""
    a[i, 0, 0], a[i, 0, 1], a[i, 0, 2] = t[0], t[1], t[2]
    a[i, 1, 0], a[i, 1, 1], a[i, 1, 2] = t[3], t[4], t[5]
    a[i, 2, 0], a[i, 2, 1], a[i, 2, 2] = t[6], t[7], t[8]


@inside_kernel
def load_symmetric(a, i):
    """Row i of an array (n, 6) as a symmetric tensor."""
    return (a[i, 0], a[i, 1], a[i, 2], a[i, 3], a[i, 4], a[i, 5])


@inside_kernel
def determinant(a):
    """Det a."""
    return (
        a[0] * (a[4] * a[8] - a[5] * a[7])
        - a[1] * (a[3] * a[8] - a[5] * a[6])
        + a[2] * (a[3] * a[7] - a[4] * a[6])
    )


@inside_kernel
def inverse(a, det):
    """Inverse of a, given its determinant."""
    d = 1.0 / det
    return (
        (a[4] * a[8] - a[5] * a[7]) * d, (a[2] * a[7] - a[1] * a[8]) * d, (a[1] * a[5] - a[2] * a[4]) * d,
        (a[5] * a[6] - a[3] * a[8]) * d, (a[0] * a[8] - a[2] * a[6]) * d, (a[2] * a[3] - a[0] * a[5]) * d,
        (a[3] * a[7] - a[4] * a[6]) * d, (a[1] * a[6] - a[0] * a[7]) * d, (a[0] * a[4] - a[1] * a[3]) * d,
    )  # fmt: skip


@inside_kernel
def product(a, b):
    """Tensor product a b."""
    return (
        a[0] * b[0] + a[1] * b[3] + a[2] * b[6],
        a[0] * b[1] + a[1] * b[4] + a[2] * b[7],
        a[0] * b[2] + a[1] * b[5] + a[2] * b[8],
        a[3] * b[0] + a[4] * b[3] + a[5] * b[6],
        a[3] * b[1] + a[4] * b[4] + a[5] * b[7],
        a[3] * b[2] + a[4] * b[5] + a[5] * b[8],
        a[6] * b[0] + a[7] * b[3] + a[8] * b[6],
        a[6] * b[1] + a[7] * b[4] + a[8] * b[7],
        a[6] * b[2] + a[7] * b[5] + a[8] * b[8],
    )


@inside_kernel
def product_transposed(a, b):
    """Tensor product a b^T."""
    return (
        a[0] * b[0] + a[1] * b[1] + a[2] * b[2],
        a[0] * b[3] + a[1] * b[4] + a[2] * b[5],
        a[0] * b[6] + a[1] * b[7] + a[2] * b[8],
        a[3] * b[0] + a[4] * b[1] + a[5] * b[2],
        a[3] * b[3] + a[4] * b[4] + a[5] * b[5],
        a[3] * b[6] + a[4] * b[7] + a[5] * b[8],
        a[6] * b[0] + a[7] * b[1] + a[8] * b[2],
        a[6] * b[3] + a[7] * b[4] + a[8] * b[5],
        a[6] * b[6] + a[7] * b[7] + a[8] * b[8],
    )


@inside_kernel
def transposed_product(a, b):
    """Tensor product a^T b."""
    return (
        a[0] * b[0] + a[3] * b[3] + a[6] * b[6],
        a[0] * b[1] + a[3] * b[4] + a[6] * b[7],
        a[0] * b[2] + a[3] * b[5] + a[6] * b[8],
        a[1] * b[0] + a[4] * b[3] + a[7] * b[6],
        a[1] * b[1] + a[4] * b[4] + a[7] * b[7],
        a[1] * b[2] + a[4] * b[5] + a[7] * b[8],
        a[2] * b[0] + a[5] * b[3] + a[8] * b[6],
        a[2] * b[1] + a[5] * b[4] + a[8] * b[7],
        a[2] * b[2] + a[5] * b[5] + a[8] * b[8],
    )


@inside_kernel
def congruence(a, s):
    """Symmetric tensor a s a^T of a tensor a and a symmetric tensor s."""
    b = (
        a[0] * s[0] + a[1] * s[3] + a[2] * s[5], a[0] * s[3] + a[1] * s[1] + a[2] * s[4],
        a[0] * s[5] + a[1] * s[4] + a[2] * s[2],
        a[3] * s[0] + a[4] * s[3] + a[5] * s[5], a[3] * s[3] + a[4] * s[1] + a[5] * s[4],
        a[3] * s[5] + a[4] * s[4] + a[5] * s[2],
        a[6] * s[0] + a[7] * s[3] + a[8] * s[5], a[6] * s[3] + a[7] * s[1] + a[8] * s[4],
        a[6] * s[5] + a[7] * s[4] + a[8] * s[2],
    )  # fmt: skip
    return (
        b[0] * a[0] + b[1] * a[1] + b[2] * a[2],
        b[3] * a[3] + b[4] * a[4] + b[5] * a[5],
        b[6] * a[6] + b[7] * a[7] + b[8] * a[8],
        b[0] * a[3] + b[1] * a[4] + b[2] * a[5],
        b[3] * a[6] + b[4] * a[7] + b[5] * a[8],
        b[6] * a[0] + b[7] * a[1] + b[8] * a[2],
    )


@inside_kernel
def transposed(a):
    """Tensor a^T."""
    return (a[0], a[3], a[6], a[1], a[4], a[7], a[2], a[5], a[8])


@inside_kernel
def full(s):
    """A symmetric tensor as nine components."""
    return (s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2])


@inside_kernel
def trace(s):
    """Trace of a symmetric tensor."""
    return s[0] + s[1] + s[2]


@inside_kernel
def mean(s):
    """Mean of the three normal components of a symmetric tensor."""
    return (s[0] + s[1] + s[2]) * THIRD


@inside_kernel
def deviator(s):
    """Deviatoric part of a symmetric tensor."""
    m = mean(s)
    return (s[0] - m, s[1] - m, s[2] - m, s[3], s[4], s[5])


@inside_kernel
def contract(s, t):
    """Double contraction s : t of two symmetric tensors."""
    return s[0] * t[0] + s[1] * t[1] + s[2] * t[2] + 2.0 * (s[3] * t[3] + s[4] * t[4] + s[5] * t[5])


@inside_kernel
def scaled(s, f):
    """Symmetric tensor f s."""
    return (f * s[0], f * s[1], f * s[2], f * s[3], f * s[4], f * s[5])


@inside_kernel
def plus(s, t):
    """Symmetric tensor s + t."""
    return (s[0] + t[0], s[1] + t[1], s[2] + t[2], s[3] + t[3], s[4] + t[4], s[5] + t[5])


@inside_kernel
def minus(s, t):
    """Symmetric tensor s - t."""
    return (s[0] - t[0], s[1] - t[1], s[2] - t[2], s[3] - t[3], s[4] - t[4], s[5] - t[5])


@inside_kernel
def plus_isotropic(s, p):
    """Symmetric tensor s + p 1."""
    return (s[0] + p, s[1] + p, s[2] + p, s[3], s[4], s[5])


@inside_kernel
def symmetric_part(a):
    """Symmetric part of a tensor."""
    return (a[0], a[4], a[8], 0.5 * (a[1] + a[3]), 0.5 * (a[5] + a[7]), 0.5 * (a[2] + a[6]))


@inside_kernel
def symmetric_determinant(s):
    """Determinant of a symmetric tensor."""
    return (
        s[0] * (s[1] * s[2] - s[4] * s[4])
        - s[3] * (s[3] * s[2] - s[4] * s[5])
        + s[5] * (s[3] * s[4] - s[1] * s[5])
    )


@inside_kernel
def symmetric_inverse(s):
    """Inverse of a symmetric tensor."""
    c11 = s[1] * s[2] - s[4] * s[4]
    c12 = s[4] * s[5] - s[3] * s[2]
    c13 = s[3] * s[4] - s[1] * s[5]
    d = 1.0 / (s[0] * c11 + s[3] * c12 + s[5] * c13)
    return (
        c11 * d,
        (s[0] * s[2] - s[5] * s[5]) * d,
        (s[0] * s[1] - s[3] * s[3]) * d,
        c12 * d,
        (s[3] * s[5] - s[0] * s[4]) * d,
        c13 * d,
    )


@inside_kernel
def symmetric_part_of_product(s, t):
    """Symmetric part of the product s t of two symmetric tensors."""
    return (
        s[0] * t[0] + s[3] * t[3] + s[5] * t[5],
        s[3] * t[3] + s[1] * t[1] + s[4] * t[4],
        s[5] * t[5] + s[4] * t[4] + s[2] * t[2],
        0.5 * (s[0] * t[3] + s[3] * t[1] + s[5] * t[4] + s[3] * t[0] + s[1] * t[3] + s[4] * t[5]),
        0.5 * (s[3] * t[5] + s[1] * t[4] + s[4] * t[2] + s[5] * t[3] + s[4] * t[1] + s[2] * t[4]),
        0.5 * (s[5] * t[0] + s[4] * t[3] + s[2] * t[5] + s[0] * t[5] + s[3] * t[4] + s[5] * t[2]),
    )


@inside_kernel
def equivalent_stress(s):
    """Von Mises stress sqrt(3/2 s:s) of a deviator s [Pa]."""
    return math.sqrt(1.5 * contract(s, s))


@inside_kernel
def is_near_one(x):
    """Whether x lies where explicit steps put ratios of volumes, and where `cube_root_near_one` is right."""
    return abs(x - 1.0) <= 0.02


@inside_kernel
def cube_root(x):
    """Cube root of x > 0."""
    return cube_root_near_one(x) if is_near_one(x) else x**THIRD


@inside_kernel
def cube_root_near_one(x):
    """Cube root of x near 1 by the binomial series, to round-off."""
    e = x - 1.0
    return 1.0 + e * (
        1.0 / 3.0
        - e
        * (
            1.0 / 9.0
            - e
            * (
                5.0 / 81.0
                - e
                * (
                    10.0 / 243.0
                    - e
                    * (22.0 / 729.0 - e * (154.0 / 6561.0 - e * (374.0 / 19683.0 - e * (935.0 / 59049.0))))
                )
            )
        )
    )

"""Principal values and axes of symmetric tensors on tuples, by Jacobi rotations."""

import math

from core_models.compilation import beside_kernel, inside_kernel
from core_models.tensors import IDENTITY, congruence, contract

SWEEPS = 12
SMALL = 1e-34  # of the squared norm: beyond round-off of the squared off-diagonal


@inside_kernel
def rotated_pair(s, v):
    """The tensor and its axes with component 12 turned to zero, and then the indices moved: 1 to 3, 2 to 1, 3 to 2."""
    c, t = 1.0, 0.0
    if s[3] != 0.0:
        half = 0.5 * (s[1] - s[0]) / s[3]
        t = math.copysign(1.0, half) / (abs(half) + math.sqrt(half * half + 1.0))
        c = 1.0 / math.sqrt(t * t + 1.0)
    sine = t * c
    turned = (s[0] - t * s[3], s[1] + t * s[3], s[2], 0.0, sine * s[5] + c * s[4], c * s[5] - sine * s[4])
    first = (c * v[0] - sine * v[1], c * v[3] - sine * v[4], c * v[6] - sine * v[7])
    second = (sine * v[0] + c * v[1], sine * v[3] + c * v[4], sine * v[6] + c * v[7])
    axes = (second[0], v[2], first[0], second[1], v[5], first[1], second[2], v[8], first[2])
    return (turned[1], turned[2], turned[0], turned[4], turned[5], turned[3]), axes


@beside_kernel
def principal(s):
    """Principal values in falling order and the tensor whose columns are their axes: s = V diag V^T.

    Parameters
    ----------
    s : symmetric tensor (six components).
    """
    values, axes = s, IDENTITY
    limit = SMALL * contract(s, s)
    for _sweep in range(SWEEPS):
        if values[3] * values[3] + values[4] * values[4] + values[5] * values[5] <= limit:
            break
        values, axes = rotated_pair(values, axes)
        values, axes = rotated_pair(values, axes)
        values, axes = rotated_pair(values, axes)
    a, b, c = values[0], values[1], values[2]
    if a < b:
        a, b, axes = b, a, _exchanged(axes)
    if b < c:
        b, c, axes = c, b, _moved(_exchanged(_moved(_moved(axes))))
    if a < b:
        a, b, axes = b, a, _exchanged(axes)
    return (a, b, c), axes


@inside_kernel
def _exchanged(v):
    """Columns 2, 1, 3."""
    return (v[1], v[0], v[2], v[4], v[3], v[5], v[7], v[6], v[8])


@inside_kernel
def _moved(v):
    """Columns 3, 1, 2."""
    return (v[2], v[0], v[1], v[5], v[3], v[4], v[8], v[6], v[7])


@inside_kernel
def from_principal(values, axes):
    """Symmetric tensor V diag V^T."""
    return congruence(axes, (values[0], values[1], values[2], 0.0, 0.0, 0.0))


@inside_kernel
def to_principal(s, v):
    """Symmetric tensor V^T s V: its components along the axes."""
    return congruence((v[0], v[3], v[6], v[1], v[4], v[7], v[2], v[5], v[8]), s)

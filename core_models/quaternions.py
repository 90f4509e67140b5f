"""Rotations as three numbers in memory and as quaternions in registers.

A quaternion (w, x, y, z) of any length but 0 stands for the rotation about (x, y, z) by the angle 2 atan2(|xyz|, w).
In memory a rotation is the vector axis * tan(angle / 4), the modified Rodrigues parameters: of the two for a rotation
the one no longer than 1, so that every rotation has one, and none can stop being a rotation by round-off.
Source: Shuster, J. Astronaut. Sci. 41 (1993) 439, eqs. 97, 249, 250.
"""

import math

from core_models.compilation import inside_kernel


@inside_kernel
def quaternion(p):
    """Quaternion of the rotation that the vector p = axis * tan(angle / 4) stands for."""
    return (1.0 - (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]), 2.0 * p[0], 2.0 * p[1], 2.0 * p[2])


@inside_kernel
def rotation_vector(q):
    """Vector axis * tan(angle / 4), no longer than 1, of a quaternion."""
    h = 1.0 / (abs(q[0]) + math.sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]))
    h = h if q[0] >= 0.0 else -h
    return (h * q[1], h * q[2], h * q[3])


@inside_kernel
def rotation_matrix(q):
    """Rotation as a tensor: 1 + 2 (w [v] + [v]^2) / (w^2 + v.v) with [v] a = v x a."""
    w, x, y, z = q
    xx, yy, zz = x * x, y * y, z * z
    h = 2.0 / (w * w + (xx + yy + zz))
    return (
        1.0 - h * (yy + zz), h * (x * y - w * z), h * (x * z + w * y),
        h * (x * y + w * z), 1.0 - h * (xx + zz), h * (y * z - w * x),
        h * (x * z - w * y), h * (y * z + w * x), 1.0 - h * (xx + yy),
    )  # fmt: skip


@inside_kernel
def turned(second, first):
    """Quaternion of the rotation `first`, then `second`."""
    a, b, c, d = second
    w, x, y, z = first
    return (
        a * w - b * x - c * y - d * z,
        a * x + b * w + c * z - d * y,
        a * y - b * z + c * w + d * x,
        a * z + b * y - c * x + d * w,
    )


@inside_kernel
def quaternion_of_matrix(r):
    """Quaternion of a rotation tensor, from the row of 4 q q^T whose diagonal is at least that of a half turn."""
    x, y, z = r[7] - r[5], r[2] - r[6], r[3] - r[1]
    xy, yz, zx = r[1] + r[3], r[5] + r[7], r[6] + r[2]
    if r[0] + r[4] + r[8] >= 0.0:
        return (1.0 + r[0] + r[4] + r[8], x, y, z)
    if r[0] >= r[4] and r[0] >= r[8]:
        return (x, 1.0 + r[0] - r[4] - r[8], xy, zx)
    if r[4] >= r[8]:
        return (y, xy, 1.0 - r[0] + r[4] - r[8], yz)
    return (z, zx, yz, 1.0 - r[0] - r[4] + r[8])

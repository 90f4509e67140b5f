"""Plane and axisymmetric geometry of straight-edged quadrilaterals, as array functions.

Every function takes `corners`, shape (m, 4, 2): the corners (r, z) [m] of m quads, counter-clockwise.
"""

import numpy as np


def edge_lengths(corners: np.ndarray) -> np.ndarray:
    """Lengths [m], shape (m, 4); edge k runs from corner k to corner k + 1."""
    return np.linalg.norm(np.roll(corners, -1, axis=1) - corners, axis=2)


def corner_jacobians(corners: np.ndarray) -> np.ndarray:
    """Cross product [m^2] of the two edges that leave each corner, shape (m, 4).

    The bilinear map of a quad is invertible exactly when all four are positive.
    """
    forward = np.roll(corners, -1, axis=1) - corners
    backward = np.roll(corners, 1, axis=1) - corners
    return forward[..., 0] * backward[..., 1] - forward[..., 1] * backward[..., 0]


def scaled_jacobians(corners: np.ndarray) -> np.ndarray:
    """Sine of the angle at each corner, shape (m, 4): 1 in a rectangle, <= 0 in an inverted quad.

    A corner with an edge of no length has the value 0.
    """
    lengths = edge_lengths(corners)
    scale = lengths * np.roll(lengths, 1, axis=1)
    return np.divide(corner_jacobians(corners), scale, out=np.zeros_like(scale), where=scale > 0.0)


def areas(corners: np.ndarray) -> np.ndarray:
    """Signed areas [m^2], shape (m,): positive when counter-clockwise."""
    return 0.5 * _twice_triangle_areas(corners).sum(axis=1)


def volumes_of_revolution(corners: np.ndarray) -> np.ndarray:
    """Volumes [m^3], shape (m,), swept by a full turn about r = 0; exact for straight edges.

    V = 2 pi * integral of r over the quad (Pappus), summed over the triangles of each edge with the origin.
    """
    r = corners[..., 0]
    return np.pi / 3.0 * (_twice_triangle_areas(corners) * (r + np.roll(r, -1, axis=1))).sum(axis=1)


def _twice_triangle_areas(corners: np.ndarray) -> np.ndarray:
    """Twice the signed area of the triangle that each edge spans with the origin, shape (m, 4)."""
    after = np.roll(corners, -1, axis=1)
    return corners[..., 0] * after[..., 1] - corners[..., 1] * after[..., 0]

"""Axisymmetric geometry of straight-edged quadrilaterals by themselves, such as the domains of material points."""

import numpy as np


def volumes_of_revolution(corners: np.ndarray) -> np.ndarray:
    """Volumes [m^3], shape (m,), that quads with corners (m, 4, 2) [m] sweep by a full turn about r = 0; exact.

    V = 2 pi * integral of r over the quad (Pappus), summed over the triangles of each edge with the origin;
    positive when counter-clockwise.
    """
    after = np.roll(corners, -1, axis=1)
    twice_areas = corners[..., 0] * after[..., 1] - corners[..., 1] * after[..., 0]
    return np.pi / 3.0 * (twice_areas * (corners[..., 0] + after[..., 0])).sum(axis=1)

"""Stiffness of a pressure that follows the surface."""

import numpy as np

from fem.facets import BoundaryFacets


def pressure_stiffness(facets: BoundaryFacets, pressure: float, x: np.ndarray) -> np.ndarray:
    """d(-load)/dx of a pressure [Pa] on facets with nodes at x (n, d) [m]: blocks (k, b d, b d) [N/m].

    load_a = -p sum_q N_a n(x), with n the outward normal times the area; not symmetric where the pressed surface ends.
    """
    slopes = facets.normal_slopes(x)
    blocks = pressure * np.einsum("qa,kqibj->kaibj", facets.shape, slopes)
    size = blocks.shape[1] * blocks.shape[2]
    return blocks.reshape(len(blocks), size, size)

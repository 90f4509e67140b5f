"""Quads cut in quarters: one for each of the 2 x 2 Gauss points, which both methods build their points from.

Quarters and points come in scikit-fem's order of points: the first local coordinate runs slowest.
"""

import numpy as np

_LOCAL_CORNERS = np.array(
    [[(s, t), (s + 0.5, t), (s + 0.5, t + 0.5), (s, t + 0.5)] for s in (0.0, 0.5) for t in (0.0, 0.5)]
)
_GAUSS = 0.5 - 0.5 / np.sqrt(3.0)
_LOCAL_POINTS = np.array([(s, t) for s in (_GAUSS, 1.0 - _GAUSS) for t in (_GAUSS, 1.0 - _GAUSS)])

EDGE_QUARTERS = ((0, 2), (2, 3), (3, 1), (1, 0))
"""Quarters along each edge of a quad in the edge's direction; edge k joins nodes k and k + 1, and is also edge k of
the quarters."""


def quarter_polygons(corners: np.ndarray) -> np.ndarray:
    """Quarters of bilinear quads, counter-clockwise: corners (m, 4, 2) -> polygons (4 m, 4, 2)."""
    return np.einsum("qcI,eIk->eqck", _shape(_LOCAL_CORNERS), corners).reshape(-1, 4, 2)


def gauss_points(corners: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Positions (4 m, 2) of the 2 x 2 Gauss points of bilinear quads (m, 4, 2), and the areas (4 m,) they weigh."""
    s, t = _LOCAL_POINTS[:, 0], _LOCAL_POINTS[:, 1]
    by_s = np.stack([t - 1, 1 - t, t, -t], axis=-1)
    by_t = np.stack([s - 1, -s, s, 1 - s], axis=-1)
    a, b = np.einsum("qI,eIk->eqk", by_s, corners), np.einsum("qI,eIk->eqk", by_t, corners)
    positions = np.einsum("qI,eIk->eqk", _shape(_LOCAL_POINTS), corners).reshape(-1, 2)
    return positions, (0.25 * (a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0])).ravel()


def _shape(local: np.ndarray) -> np.ndarray:
    """Bilinear shape functions at local coordinates (..., 2) in [0, 1]^2: (..., 4)."""
    s, t = local[..., 0], local[..., 1]
    return np.stack([(1 - s) * (1 - t), s * (1 - t), s * t, (1 - s) * t], axis=-1)

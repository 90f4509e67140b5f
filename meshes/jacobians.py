"""Jacobians of the maps from reference cells to elements, and figures made of them, for all kinds."""

from functools import cache
from math import sqrt

import numpy as np

from meshes.kinds import KINDS
from meshes.shape_functions import shape_gradients

CHUNK = 16384  # elements at a time, to bound the memory that their matrices take

_PERFECT = {("tri", 2): 2.0 / sqrt(3.0), ("tet", 3): sqrt(2.0)}  # inverse of the regular simplex's value


def jacobian_matrices(name: str, nodes: np.ndarray, places: np.ndarray) -> np.ndarray:
    """dx_i/dxi_k of elements with nodes (m, a, d) at reference coordinates (q, d): (m, q, d, d)."""
    return np.einsum("eai,qak->eqik", nodes, shape_gradients(name, places), optimize=True)


def determinants(matrices: np.ndarray) -> np.ndarray:
    """Determinants (...) of matrices (..., d, d), d = 2 or 3."""
    m = np.moveaxis(matrices, (-2, -1), (0, 1))
    if len(m) == 2:
        return m[0, 0] * m[1, 1] - m[0, 1] * m[1, 0]
    return (
        m[0, 0] * (m[1, 1] * m[2, 2] - m[1, 2] * m[2, 1])
        - m[0, 1] * (m[1, 0] * m[2, 2] - m[1, 2] * m[2, 0])
        + m[0, 2] * (m[1, 0] * m[2, 1] - m[1, 1] * m[2, 0])
    )


def smallest_scaled_jacobians(name: str, points: np.ndarray, cells: np.ndarray) -> np.ndarray:
    """For each element the least scaled Jacobian over its check places: (m,).

    det J / product of the lengths of the edges' tangents, times a factor that makes it 1 in the regular element;
    <= 0 where the map folds over. In a simplex the d edges of the corner where the product is largest count.
    Check places: the corners; of quadratic kinds also the middles of edges, faces and cell.
    """
    least = np.empty(len(cells))
    for first in range(0, len(cells), CHUNK):
        part = slice(first, first + CHUNK)
        least[part] = _scaled(name, points[cells[part]]).min(axis=1)
    return least


def _scaled(name: str, nodes: np.ndarray) -> np.ndarray:
    """Scaled Jacobians (m, q) at the check places of elements with nodes (m, a, d)."""
    kind, matrices = KINDS[name], jacobian_matrices(name, nodes, check_places(name))
    if kind.simplex:
        tangents = np.einsum("eqik,ckl->eqcil", matrices, _edge_directions(name), optimize=True)
        scale = np.sqrt((tangents**2).sum(axis=3)).prod(axis=3).max(axis=2)
    else:
        scale = np.sqrt((matrices**2).sum(axis=2)).prod(axis=2)
    values = determinants(matrices)
    factor = _PERFECT.get((kind.linear.rstrip("0123456789"), kind.dimension), 1.0)
    return np.divide(factor * values, scale, out=np.zeros_like(scale), where=scale > 0.0)


@cache
def check_places(name: str) -> np.ndarray:
    """Reference coordinates (q, d) at which an element's map has to be invertible."""
    fullest = {"quad8": "quad9", "hex20": "hex27"}.get(name, name)
    return KINDS[fullest].reference_nodes


@cache
def _edge_directions(name: str) -> np.ndarray:
    """Reference directions of the d edges that meet at a corner of a simplex, as columns, for each corner."""
    kind = KINDS[name]
    corners = kind.reference_nodes[: kind.corners]
    return np.array([np.delete(corners - corner, i, axis=0).T for i, corner in enumerate(corners)])

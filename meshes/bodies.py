"""The bodies of a mesh: cells that share nodes belong to one body, and no two bodies overlap."""

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from core_models.errors import MeshError
from meshes.facets import place
from meshes.kinds import KINDS
from meshes.overlap import find_overlap


def bodies_of_nodes(cells: np.ndarray, count: int) -> np.ndarray:
    """For each of `count` nodes the number of its body, from 0 in the order of the bodies' first nodes."""
    first = np.repeat(cells[:, 0], cells.shape[1] - 1)
    links = coo_array((np.ones(len(first)), (first, cells[:, 1:].ravel())), shape=(count, count))
    return connected_components(links, directed=False)[1]


def check_bodies_apart(points: np.ndarray, kind: str, cells: np.ndarray) -> None:
    """Raise MeshError, with the extents, when two bodies overlap by more than a touch."""
    body = bodies_of_nodes(cells, len(points))
    count = int(body.max()) + 1
    if count == 1:
        return
    low, high = np.full((count, points.shape[1]), np.inf), np.full((count, points.shape[1]), -np.inf)
    np.minimum.at(low, body, points)
    np.maximum.at(high, body, points)
    linear = KINDS[kind].linear
    corners = points[cells[:, : KINDS[kind].corners]]
    order = np.argsort(body[cells[:, 0]], kind="stable")
    cells_of = np.split(order, np.cumsum(np.bincount(body[cells[:, 0]]))[:-1])
    for i, j in _pairs_that_may_meet(low, high):
        overlap = find_overlap(linear, corners[cells_of[i]], corners[cells_of[j]])
        if overlap is not None:
            extents = np.minimum(high[i], high[j]) - np.maximum(low[i], low[j])
            raise MeshError(
                f"bodies {i} and {j} of {count} overlap: their boxes share "
                f"{' x '.join(f'{extent:.4g}' for extent in extents)} m, and elements {cells_of[i][overlap.first]} "
                f"and {cells_of[j][overlap.second]} lie in the same place {place(overlap.place[None])}; "
                "move the bodies apart, or merge nodes that coincide"
            )


def _pairs_that_may_meet(low: np.ndarray, high: np.ndarray) -> np.ndarray:
    """Pairs (k, 2) of bodies whose boxes overlap."""
    reach = np.linalg.norm(high - low, axis=1).max()
    pairs = cKDTree(0.5 * (low + high)).query_pairs(reach, output_type="ndarray")
    i, j = pairs.T
    meet = ((low[i] < high[j]) & (low[j] < high[i])).all(axis=1)
    return pairs[meet][np.lexsort(pairs[meet].T[::-1])]

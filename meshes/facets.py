"""Facets of elements: which belong to one element only (the rim), and finding facets by their nodes."""

from typing import NamedTuple

import numpy as np

from core_models.errors import MeshError
from meshes.kinds import KINDS


class Facets(NamedTuple):
    """All facets of a mesh, cell by cell.

    nodes : (m f, b) their nodes, seen from outside their cell. corners : number of vertex nodes of a facet, which
    come first. key : (m f,) a number of the set of corners, the same in both cells. uses : (m f,) cells that share it.
    """

    nodes: np.ndarray
    corners: int
    key: np.ndarray
    uses: np.ndarray

    def rim(self) -> np.ndarray:
        """Numbers of the facets that belong to one cell only."""
        return np.flatnonzero(self.uses == 1)


def find_facets(name: str, points: np.ndarray, cells: np.ndarray) -> Facets:
    """The facets of cells (m, a); MeshError when one is shared by more than two, or by two on the same side."""
    kind = KINDS[name]
    nodes = cells[:, np.array(kind.facets)].reshape(-1, len(kind.facets[0]))
    corners = KINDS[kind.facet].corners if kind.dimension == 3 else 2
    key, uses = _numbered(nodes[:, :corners], len(points))
    facets = Facets(nodes, corners, key, uses)
    _check_sides(points, facets)
    return facets


def match(facets: Facets, wanted: np.ndarray) -> np.ndarray:
    """For each wanted facet, given by its nodes (k, >= corners) in any order, a number into `facets` or -1.

    Of a facet between two cells that of either is returned.
    """
    count = int(facets.nodes.max()) + 1
    there = ((wanted >= 0) & (wanted < count))[:, : facets.corners].all(axis=1)
    wanted = np.where(there[:, None], wanted[:, : facets.corners], 0)
    near = np.zeros(count, dtype=bool)
    near[wanted] = True
    candidates = np.flatnonzero(near[facets.nodes[:, : facets.corners]].all(axis=1))
    both = np.concatenate([facets.nodes[candidates, : facets.corners], wanted])
    key, _ = _numbered(both, count)
    number = np.full(len(both), -1)
    number[key[: len(candidates)]] = candidates
    return np.where(there, number[key[len(candidates) :]], -1)


def facet_vectors(corners: np.ndarray) -> np.ndarray:
    """Normals (k, d) of facets with corners (k, c, d), as long as their lengths [m] or areas [m^2].

    2-D: to the right of the edge. 3-D: by the right hand; of a warped quad its mean.
    """
    if corners.shape[2] == 2:
        along = corners[:, 1] - corners[:, 0]
        return np.column_stack([along[:, 1], -along[:, 0]])
    if corners.shape[1] == 3:
        return 0.5 * np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    return 0.5 * np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])


def _numbered(corners: np.ndarray, count: int) -> tuple[np.ndarray, np.ndarray]:
    """A number for each set of nodes, and how often that set occurs; both per row."""
    ordered = np.sort(corners, axis=1)
    low = ordered[:, 0] * count + ordered[:, 1]
    high = ordered[:, 2] * count + ordered[:, -1] if ordered.shape[1] > 2 else low
    order = np.lexsort((high, low))
    new = np.ones(len(order), dtype=bool)
    new[1:] = (np.diff(low[order]) != 0) | (np.diff(high[order]) != 0)
    key = np.empty(len(order), dtype=np.int64)
    key[order] = np.cumsum(new) - 1
    return key, np.bincount(key)[key]


def _check_sides(points: np.ndarray, facets: Facets) -> None:
    """Raise MeshError unless at most two cells share a facet, one on each side of it."""
    if facets.uses.max() > 2:
        which = facets.nodes[facets.uses.argmax(), : facets.corners]
        raise MeshError(
            f"the facet {place(points[which])} belongs to more than two cells; remove the overlap"
        )
    shared = np.flatnonzero(facets.uses == 2)
    if len(shared) == 0:
        return
    pairs = shared[np.argsort(facets.key[shared], kind="stable")].reshape(-1, 2)
    one, other = facets.nodes[pairs[:, 0], : facets.corners], facets.nodes[pairs[:, 1], : facets.corners]
    if facets.corners == 2:
        folded = one[:, 0] == other[:, 0]
    else:
        start = (other == one[:, :1]).argmax(axis=1)
        folded = other[np.arange(len(other)), (start + 1) % facets.corners] != one[:, -1]
    if folded.any():
        which = facets.nodes[pairs[folded.argmax(), 0], : facets.corners]
        raise MeshError(
            f"two cells lie on the same side of the facet {place(points[which])}; remove the overlap"
        )


def place(corners: np.ndarray) -> str:
    """Where something with corners (c, d) is, for a message: both ends of an edge, else the middle."""
    if corners.shape == (2, 2):
        return f"from {_tuple(corners[0])} to {_tuple(corners[1])} m"
    return f"near {_tuple(corners.mean(axis=0))} m"


def _tuple(point: np.ndarray) -> str:
    return "(" + ", ".join(f"{value:.4g}" for value in point) + ")"

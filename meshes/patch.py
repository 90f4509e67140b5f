"""Even patches of elements, mapped to where they belong and welded into one body."""

from collections.abc import Callable, Mapping, Sequence
from itertools import permutations
from typing import NamedTuple

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from meshes.elevate import with_middle_nodes
from meshes.kinds import KINDS, find_kind

SIDES = {
    2: (("left", "right"), ("bottom", "top")),
    3: (("left", "right"), ("front", "back"), ("bottom", "top")),
}
"""Names of the boundaries at the lower and upper end of each coordinate."""

WELD = 1e-9
"""Distance below which nodes of neighbouring patches are the same node, as a part of the body's size."""


class Patch(NamedTuple):
    """Points (n, d), cells (m, a), and boundaries: name -> (k, b) nodes of facets."""

    points: np.ndarray
    cells: np.ndarray
    boundaries: dict[str, np.ndarray]

    def mapped(self, function: Callable[[np.ndarray], np.ndarray]) -> "Patch":
        """The patch with its points (n, d) moved by a function."""
        return self._replace(points=function(self.points))

    def renamed(self, names: Mapping[str, str]) -> "Patch":
        """The patch with those boundaries only that are among `names`, under their new names."""
        return self._replace(boundaries={new: self.boundaries[old] for old, new in names.items()})


def even_patch(counts: Sequence[int], kind: str) -> Patch:
    """The unit square or cube in counts[0] x counts[1] (x counts[2]) parts; the first coordinate runs fastest.

    A part is one quad or hexahedron, or is cut along its diagonal into 2 triangles or 6 tetrahedra. Boundaries: left,
    right (x), bottom, top (last coordinate), in 3-D also front, back (y).
    """
    parts, wanted = np.asarray(counts), find_kind(kind)
    points, cells = _lattice(parts, wanted.linear)
    if wanted.degree == 2:
        points, cells = with_middle_nodes(points, cells, kind)
    facets = cells[:, np.array(wanted.facets)].reshape(-1, len(wanted.facets[0]))
    boundaries = {}
    for axis, names in enumerate(SIDES[wanted.dimension]):
        for name, end in zip(names, (0, parts[axis]), strict=True):
            there = points[:, axis] == end
            boundaries[name] = facets[there[facets].all(axis=1)]
    return Patch(points / parts, cells, boundaries)


def weld(patches: Sequence[Patch]) -> Patch:
    """One patch of several: nodes in the same place become one, boundaries of one name are joined."""
    points = np.concatenate([patch.points for patch in patches])
    number = _same_places(points)
    starts = np.cumsum([0, *(len(patch.points) for patch in patches)])
    cells = np.concatenate([number[start + p.cells] for start, p in zip(starts, patches, strict=False)])
    boundaries: dict[str, list[np.ndarray]] = {}
    for start, patch in zip(starts, patches, strict=False):
        for name, nodes in patch.boundaries.items():
            boundaries.setdefault(name, []).append(number[start + nodes])
    first = np.unique(number, return_index=True)[1]
    return Patch(points[first], cells, {name: np.concatenate(parts) for name, parts in boundaries.items()})


def _same_places(points: np.ndarray) -> np.ndarray:
    """New numbers (n,) of the nodes, one per place, in the order in which places come first."""
    pairs = cKDTree(points).query_pairs(WELD * np.ptp(points, axis=0).max(), output_type="ndarray")
    links = coo_array((np.ones(len(pairs)), (pairs[:, 0], pairs[:, 1])), shape=(len(points),) * 2)
    label = connected_components(links, directed=False)[1]
    order = np.unique(label, return_index=True)[1].argsort().argsort()
    return order[label]


def _lattice(parts: np.ndarray, linear: str) -> tuple[np.ndarray, np.ndarray]:
    """Points 0 <= x_k <= parts[k] with whole coordinates, and the cells of a linear kind on them."""
    kind = KINDS[linear]
    axes = np.meshgrid(*(np.arange(count + 1.0) for count in parts[::-1]), indexing="ij")
    points = np.stack(axes[::-1], axis=-1).reshape(-1, kind.dimension)
    stride = np.concatenate([[1], np.cumprod(parts[:-1] + 1)])
    origins = np.stack(np.meshgrid(*(np.arange(n) for n in parts[::-1]), indexing="ij")[::-1], axis=-1)
    first = origins.reshape(-1, kind.dimension) @ stride
    shapes = _paths(kind.dimension) if kind.simplex else [kind.reference_nodes.astype(np.int64)]
    offsets = np.array([shape @ stride for shape in shapes])
    return points, (first[:, None, None] + offsets).reshape(-1, kind.nodes)


def _paths(dimension: int) -> list[np.ndarray]:
    """Corners of the simplices of a unit cube: the ways along its edges from 0 to 1, positively oriented."""
    unit = np.eye(dimension, dtype=np.int64)
    paths = []
    for order in permutations(range(dimension)):
        path = np.concatenate([np.zeros((1, dimension), np.int64), np.cumsum(unit[list(order)], axis=0)])
        if np.linalg.det(path[1:].astype(float)) < 0.0:
            path[[1, 2]] = path[[2, 1]]
        paths.append(path)
    return paths

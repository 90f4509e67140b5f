"""A rectangle or box cut into elements of any kind, even or distorted."""

from collections.abc import Sequence
from itertools import permutations

import numpy as np

from core_models.errors import MeshError
from meshes.boundaries import name_facets
from meshes.elevate import with_middle_nodes
from meshes.facets import find_facets
from meshes.kinds import KINDS, find_kind
from meshes.mesh import Mesh

SIDES = {
    2: (("left", "right"), ("bottom", "top")),
    3: (("left", "right"), ("front", "back"), ("bottom", "top")),
}
"""Names of the boundaries at the lower and upper end of each coordinate."""


def block(
    lower: Sequence[float],
    upper: Sequence[float],
    counts: Sequence[int],
    kind: str = "quad4",
    distortion: float = 0.0,
    seed: int = 0,
) -> Mesh:
    """A block lower <= x <= upper in counts[0] x counts[1] (x counts[2]) even parts.

    lower, upper : corners [m], d coordinates each. counts : parts along each coordinate; a part is one quad or
    hexahedron, or is cut along its diagonal into 2 triangles or 6 tetrahedra. kind : of the elements, of dimension
    d. distortion : largest random shift of the nodes inside, along each coordinate, as a part of the distance of
    nodes, from 0 up to 0.5; those on the boundary stay. seed : of the random shifts.
    Boundaries: left, right (x), bottom, top (last coordinate), in 3-D also front, back (y).
    Raises MeshError when a parameter is outside its range, or when a distortion inverts an element.
    """
    low, high = np.asarray(lower, dtype=float), np.asarray(upper, dtype=float)
    parts = np.asarray(counts)
    dimension = find_kind(kind).dimension
    _check(low, high, parts, dimension, kind, distortion)
    points, cells = unit_block(parts, kind)
    facets = find_facets(kind, points, cells)
    ends = {}
    for axis, (at_low, at_high) in enumerate(SIDES[dimension]):
        ends[at_low], ends[at_high] = points[:, axis] == 0.0, points[:, axis] == parts[axis]
    inside = ((points > 0.0) & (points < parts)).all(axis=1)
    shift = np.random.default_rng(seed).uniform(-distortion, distortion, points.shape) / KINDS[kind].degree
    moved = points + np.where(inside[:, None], shift, 0.0)
    share = moved / parts
    return Mesh(low * (1.0 - share) + high * share, kind, cells, name_facets(facets, ends), source="block")


def unit_block(parts: np.ndarray, kind: str) -> tuple[np.ndarray, np.ndarray]:
    """Points and cells of the block 0 <= x_k <= parts[k] in parts of size 1; the first coordinate runs fastest."""
    wanted = find_kind(kind)
    linear = KINDS[wanted.linear]
    dimension = wanted.dimension
    axes = np.meshgrid(*(np.arange(count + 1.0) for count in parts[::-1]), indexing="ij")
    points = np.stack(axes[::-1], axis=-1).reshape(-1, dimension)
    stride = np.concatenate([[1], np.cumprod(parts[:-1] + 1)])
    origins = np.stack(np.meshgrid(*(np.arange(n) for n in parts[::-1]), indexing="ij")[::-1], axis=-1)
    first = origins.reshape(-1, dimension) @ stride
    paths = _paths(dimension) if linear.simplex else [linear.reference_nodes.astype(int)]
    offsets = np.array([path @ stride for path in paths])
    cells = (first[:, None, None] + offsets).reshape(-1, linear.nodes)
    return (points, cells) if wanted is linear else with_middle_nodes(points, cells, kind)


def _paths(dimension: int) -> list[np.ndarray]:
    """Corners of the simplices of a unit cube: the ways along its edges from 0 to 1, positively oriented."""
    paths = []
    for order in permutations(range(dimension)):
        path = np.concatenate(
            [np.zeros((1, dimension), int), np.cumsum(np.eye(dimension, dtype=int)[list(order)], 0)]
        )
        if np.linalg.det(path[1:].astype(float)) < 0.0:
            path[[1, 2]] = path[[2, 1]]
        paths.append(path)
    return paths


def _check(
    low: np.ndarray, high: np.ndarray, parts: np.ndarray, dimension: int, kind: str, distortion: float
) -> None:
    """Raise MeshError for the first parameter that is outside its range."""
    for name, value in (("lower", low), ("upper", high), ("counts", parts)):
        if value.shape != (dimension,):
            raise MeshError(
                f"block: {name} is {value.tolist()}; give {dimension} numbers for {kind} elements"
            )
    if not (np.isfinite(low).all() and np.isfinite(high).all() and (low < high).all()):
        raise MeshError(
            f"block: lower is {low.tolist()}, upper {high.tolist()}; give finite numbers with lower < upper"
        )
    if parts.dtype.kind not in "iu" or parts.min() < 1:
        raise MeshError(f"block: counts is {parts.tolist()}; give whole numbers of at least 1")
    if not 0.0 <= distortion < 0.5:
        raise MeshError(f"block: distortion is {distortion}; give a number from 0 up to 0.5")

"""Whether two bodies overlap: by the separating axes of the simplices that their cells consist of."""

from itertools import combinations, product
from typing import NamedTuple

import numpy as np
from scipy.spatial import cKDTree

TOUCH = 1e-6
"""Depth, as a part of a cell's size, up to which cells that share space only touch."""

CHUNK = 8192  # pairs of cells at a time, to bound the memory

_SIMPLICES = {
    "tri3": ((0, 1, 2),),
    "quad4": ((0, 1, 2), (0, 2, 3)),
    "tet4": ((0, 1, 2, 3),),
    "hex8": ((0, 1, 2, 6), (0, 2, 3, 6), (0, 3, 7, 6), (0, 7, 4, 6), (0, 4, 5, 6), (0, 5, 1, 6)),
}
"""Cells as simplices, by their corners."""


class Overlap(NamedTuple):
    """A cell of each body that lie in the same place, and about where (d,) [m]."""

    first: int
    second: int
    place: np.ndarray


def find_overlap(kind: str, a: np.ndarray, b: np.ndarray) -> Overlap | None:
    """The first pair of cells of two bodies that overlap by more than a touch; None without any.

    a, b : corners (m, c, d) [m] of the cells, of a linear kind; quadratic ones count with straight edges.
    """
    pairs = _near(a, b)
    split = np.array(_SIMPLICES[kind])
    for start in range(0, len(pairs), CHUNK):
        part = pairs[start : start + CHUNK]
        hit = np.zeros(len(part), dtype=bool)
        for one, other in product(split, split):
            hit |= _intersect(a[part[:, 0]][:, one], b[part[:, 1]][:, other])
        if hit.any():
            i, j = part[hit.argmax()]
            low, high = np.maximum(a[i].min(0), b[j].min(0)), np.minimum(a[i].max(0), b[j].max(0))
            return Overlap(int(i), int(j), 0.5 * (low + high))
    return None


def _near(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Numbers (k, 2) of the cells with corners (m, c, d) whose boxes overlap, in order."""
    boxes = [(cells.min(axis=1), cells.max(axis=1)) for cells in (a, b)]
    low = np.maximum(boxes[0][0].min(axis=0), boxes[1][0].min(axis=0))
    high = np.minimum(boxes[0][1].max(axis=0), boxes[1][1].max(axis=0))
    inside = [np.flatnonzero(((box[1] > low) & (box[0] < high)).all(axis=1)) for box in boxes]
    if min(map(len, inside)) == 0:
        return np.empty((0, 2), dtype=np.int64)
    trees, reach = [], 0.0
    for (lower, upper), some in zip(boxes, inside, strict=True):
        trees.append(cKDTree(0.5 * (lower + upper)[some]))
        reach += 0.5 * np.linalg.norm((upper - lower)[some], axis=1).max()
    found = trees[0].query_ball_tree(trees[1], reach)
    one = np.repeat(inside[0], [len(others) for others in found])
    other = inside[1][np.concatenate([np.sort(np.array(others, dtype=np.int64)) for others in found])]
    apart = (boxes[0][1][one] <= boxes[1][0][other]) | (boxes[1][1][other] <= boxes[0][0][one])
    return np.column_stack([one, other])[~apart.any(axis=1)]


def _intersect(p: np.ndarray, q: np.ndarray) -> np.ndarray:
    """Whether simplices p and q (k, d + 1, d), pair by pair, overlap along every axis that could separate them."""
    size = np.minimum(np.ptp(p, axis=1).max(axis=1), np.ptp(q, axis=1).max(axis=1))
    overlapping = np.ones(len(p), dtype=bool)
    for axis in _axes(p, q):
        length = np.linalg.norm(axis, axis=1)
        along_p, along_q = np.einsum("kcd,kd->kc", p, axis), np.einsum("kcd,kd->kc", q, axis)
        depth = np.minimum(along_p.max(1), along_q.max(1)) - np.maximum(along_p.min(1), along_q.min(1))
        parallel = length <= TOUCH * size ** (axis.shape[1] - 1)
        overlapping &= (depth > TOUCH * size * length) | parallel
    return overlapping


def _axes(p: np.ndarray, q: np.ndarray) -> list[np.ndarray]:
    """Directions (k, d) normal to the facets, and in 3-D to one edge of each."""
    if p.shape[2] == 2:
        edges = [s[:, i] - s[:, j] for s in (p, q) for i, j in combinations(range(3), 2)]
        return [np.column_stack([-edge[:, 1], edge[:, 0]]) for edge in edges]
    edges_p, edges_q = (
        [simplex[:, i] - simplex[:, j] for i, j in combinations(range(4), 2)] for simplex in (p, q)
    )
    faces = [
        np.cross(simplex[:, j] - simplex[:, i], simplex[:, k] - simplex[:, i])
        for simplex in (p, q)
        for i, j, k in combinations(range(4), 3)
    ]
    return faces + [np.cross(one, other) for one, other in product(edges_p, edges_q)]

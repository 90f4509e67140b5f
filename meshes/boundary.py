"""The boundary of a mesh of quads: its closed loop of edges, cut into named and ordered pieces."""

from collections.abc import Mapping, Sequence
from difflib import get_close_matches

import numpy as np

from core_models.errors import MeshError

BOUNDARY_NAMES = ("foot", "side", "rear", "axis")
"""The boundaries every mesh names, as they follow each other counter-clockwise."""

_HOW_TO_NAME = 'name the boundary edges foot, side, rear and axis (gmsh: Physical Curve("foot") = {...};)'
_HOW_TO_MERGE = "merge nodes that coincide (gmsh: Coherence Mesh;)"


def order_boundaries(
    points: np.ndarray, quads: np.ndarray, named: Mapping[str, np.ndarray]
) -> dict[str, np.ndarray]:
    """Put the edges of each named boundary in order, counter-clockwise round the body.

    Parameters: points (n, 2) [m]; quads (m, 4), node numbers, counter-clockwise; named: for each of
    BOUNDARY_NAMES its node pairs (k, 2), in any order and direction.
    Returns the same names with their pairs head to tail: foot from axis to rim, side from foot to rear,
    rear from rim to axis, axis from rear to foot.
    Raises MeshError when a name is missing, or the edges are not four pieces of one closed loop.
    """
    _require_names(named)
    loop = boundary_loop(points, quads)
    labels = _label(points, loop, named)
    starts = [i for i, label in enumerate(labels) if label != labels[i - 1]]
    sequence = [labels[i] for i in starts]
    if "foot" in sequence:
        first = sequence.index("foot")
        starts, sequence = starts[first:] + starts[:first], sequence[first:] + sequence[:first]
    if tuple(sequence) != BOUNDARY_NAMES:
        raise MeshError(
            f"the boundaries follow each other counter-clockwise as {', '.join(sequence)}, "
            f"not as {', '.join(BOUNDARY_NAMES)}; correct the names of the boundary edges"
        )
    loop = np.roll(loop, -starts[0], axis=0)
    cuts = np.cumsum([labels.count(name) for name in BOUNDARY_NAMES])[:-1]
    return dict(zip(BOUNDARY_NAMES, np.split(loop, cuts), strict=True))


def boundary_loop(points: np.ndarray, quads: np.ndarray) -> np.ndarray:
    """Node pairs (k, 2) of the edges that belong to one quad only, head to tail round the body.

    Raises MeshError when they do not form exactly one closed loop.
    """
    edges = np.stack([quads, np.roll(quads, -1, axis=1)], axis=2).reshape(-1, 2)
    _, where, count = np.unique(np.sort(edges, axis=1), axis=0, return_inverse=True, return_counts=True)
    shared = count[where.ravel()]
    if shared.max() > 2:
        edge = _where(points, edges[shared.argmax()])
        raise MeshError(f"the edge {edge} belongs to more than two quads; remove the overlap")
    free = edges[shared == 1]
    after = dict(free.tolist())
    node, loop = int(free[0, 0]), []
    while node in after:
        loop.append((node, after.pop(node)))
        node = loop[-1][1]
    if len(loop) < len(free) or node != loop[0][0]:
        edge = _where(points, next(iter(after.items()), loop[-1]))
        raise MeshError(
            f"the boundary is not one closed loop (the edge {edge} is apart from the rest): "
            f"{_HOW_TO_MERGE} and leave one body without holes"
        )
    return np.array(loop)


def _require_names(named: Mapping[str, np.ndarray]) -> None:
    """Raise MeshError when one of BOUNDARY_NAMES is not there, with the nearest name that is."""
    for name in BOUNDARY_NAMES:
        if name not in named:
            nearest = get_close_matches(name, named, 1, 0.4) if named else []
            found = (
                f"the nearest name there is '{nearest[0]}'"
                if nearest
                else f"named are: {', '.join(named) or 'none'}"
            )
            raise MeshError(f"the boundary '{name}' is missing ({found}); {_HOW_TO_NAME}")


def _label(points: np.ndarray, loop: np.ndarray, named: Mapping[str, np.ndarray]) -> list[str]:
    """The boundary name of each edge of the loop; raises MeshError unless each edge has exactly one."""
    label_of: dict[frozenset[int], str] = {frozenset(edge): "" for edge in loop.tolist()}
    for name in BOUNDARY_NAMES:
        for pair in np.asarray(named[name]).tolist():
            edge = frozenset(pair)
            if edge not in label_of:
                raise MeshError(
                    f"the edge {_where(points, pair)} of '{name}' is not on the rim; take the name off it"
                )
            if label_of[edge] not in ("", name):
                raise MeshError(
                    f"the edge {_where(points, pair)} is in both '{label_of[edge]}' and '{name}'; keep one"
                )
            label_of[edge] = name
    for pair, label in zip(loop.tolist(), label_of.values(), strict=True):
        if not label:
            raise MeshError(
                f"the boundary edge {_where(points, pair)} has no name; {_HOW_TO_NAME}; "
                f"if it is inside the body, {_HOW_TO_MERGE}"
            )
    return list(label_of.values())


def _where(points: np.ndarray, pair: Sequence[int]) -> str:
    """Where an edge is: the coordinates of its ends."""
    (r0, z0), (r1, z1) = (points[node] if 0 <= node < len(points) else (np.nan, np.nan) for node in pair)
    return f"from (r, z) = ({r0:.4g}, {z0:.4g}) m to ({r1:.4g}, {z1:.4g}) m"

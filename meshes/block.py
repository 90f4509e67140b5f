"""A rectangle or box cut into elements of any kind, even or distorted."""

from collections.abc import Sequence

import numpy as np

from core_models.errors import MeshError
from meshes.kinds import KINDS, find_kind
from meshes.mesh import Mesh
from meshes.parameters import check_counts
from meshes.patch import SIDES, even_patch

__all__ = ["SIDES", "block"]


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
    dimension = find_kind(kind).dimension
    low, high = _ends(lower, upper, dimension, kind)
    parts = check_counts("block", counts, kind)
    if not 0.0 <= distortion < 0.5:
        raise MeshError(f"block: distortion is {distortion}; give a number from 0 up to 0.5")
    points, cells, boundaries = even_patch(parts, kind)
    inside = ((points > 0.0) & (points < 1.0)).all(axis=1)
    shift = np.random.default_rng(seed).uniform(-distortion, distortion, points.shape)
    share = points + np.where(inside[:, None], shift, 0.0) / (parts * KINDS[kind].degree)
    return Mesh(low * (1.0 - share) + high * share, kind, cells, boundaries, source="block")


def _ends(
    lower: Sequence[float], upper: Sequence[float], dimension: int, kind: str
) -> tuple[np.ndarray, np.ndarray]:
    """Both corners; MeshError unless they have `dimension` finite coordinates with lower < upper."""
    low, high = np.asarray(lower, dtype=float), np.asarray(upper, dtype=float)
    for name, value in (("lower", low), ("upper", high)):
        if value.shape != (dimension,):
            raise MeshError(
                f"block: {name} is {value.tolist()}; give {dimension} numbers for {kind} elements"
            )
    if not (np.isfinite(low).all() and np.isfinite(high).all() and (low < high).all()):
        raise MeshError(
            f"block: lower is {low.tolist()}, upper {high.tolist()}; give finite numbers with lower < upper"
        )
    return low, high

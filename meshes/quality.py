"""Quality figures of a mesh: how far its elements are from even ones, and how large they are."""

from itertools import combinations
from typing import NamedTuple

import numpy as np

from meshes.jacobians import smallest_scaled_jacobians
from meshes.kinds import KINDS
from meshes.measure import measures, volumes_of_turn
from meshes.mesh import Mesh


class Quality(NamedTuple):
    """Figures of a whole mesh.

    scaled_jacobian : least and largest over the elements of an element's worst: 1 in a square, cube or regular
    simplex, <= 0 where it folds. aspect_ratio : longest edge by shortest of an element, >= 1. edge : lengths [m],
    straight between corners. measure : areas of elements [m^2], in 3-D volumes [m^3]; total that of all. turn : volume
    of the full turn about r = 0 [m^3], None in 3-D and for a body that reaches beyond the axis.
    """

    elements: int
    nodes: int
    min_scaled_jacobian: float
    max_scaled_jacobian: float
    min_aspect_ratio: float
    max_aspect_ratio: float
    min_edge: float
    max_edge: float
    min_measure: float
    max_measure: float
    total: float
    turn: float | None


def quality(mesh: Mesh) -> Quality:
    """Quality figures of a mesh of any kind."""
    jacobians = smallest_scaled_jacobians(mesh.kind, mesh.points, mesh.cells)
    lengths = edge_lengths(mesh)
    aspect_ratios = lengths.max(axis=1) / lengths.min(axis=1)
    sizes = measures(mesh)
    revolved = mesh.dimension == 2 and mesh.points[:, 0].min() >= 0.0
    return Quality(
        elements=len(mesh.cells),
        nodes=len(mesh.points),
        min_scaled_jacobian=float(jacobians.min()),
        max_scaled_jacobian=float(jacobians.max()),
        min_aspect_ratio=float(aspect_ratios.min()),
        max_aspect_ratio=float(aspect_ratios.max()),
        min_edge=float(lengths.min()),
        max_edge=float(lengths.max()),
        min_measure=float(sizes.min()),
        max_measure=float(sizes.max()),
        total=float(sizes.sum()),
        turn=float(volumes_of_turn(mesh).sum()) if revolved else None,
    )


def edge_lengths(mesh: Mesh) -> np.ndarray:
    """Lengths (m, e) [m] of the straight edges between the corners of the elements."""
    corners = mesh.corners()
    kind = KINDS[mesh.kind]
    reference = kind.reference_nodes[: kind.corners]
    pairs = [
        (i, j)
        for i, j in combinations(range(kind.corners), 2)
        if kind.simplex or np.abs(reference[i] - reference[j]).sum() == 1.0
    ]
    i, j = np.array(pairs).T
    return np.linalg.norm(corners[:, i] - corners[:, j], axis=2)

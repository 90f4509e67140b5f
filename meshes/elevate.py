"""From linear to quadratic elements: nodes in the middle of edges, faces and cells."""

from collections.abc import Callable, Mapping
from dataclasses import replace

import numpy as np

from core_models.errors import MeshError
from meshes.boundaries import require_boundaries
from meshes.kinds import KINDS, find_kind
from meshes.mesh import Mesh
from meshes.shape_functions import shape_values

SERENDIPITY = {"quad9": "quad8", "hex27": "hex20"}
"""The kinds with nodes in the middle of faces and cells, and those without them."""

Projection = Callable[[np.ndarray], np.ndarray]


def elevate(mesh: Mesh, kind: str, curved: Mapping[str, Projection] | None = None) -> Mesh:
    """The same body in quadratic elements of the same shape; corners keep their numbers.

    Middle nodes lie at the mean of the corners of their edge, face or cell, and those on curved boundaries where the
    boundary's function puts them; nodes within faces and cells then follow their edges.
    kind : 'quad8' or 'quad9' from quad4, 'tri6' from tri3, 'hex20' or 'hex27' from hex8, 'tet10' from tet4; the
    mesh's own kind gives it back. curved : boundary name -> function of positions (k, d) [m] that gives the nearest
    ones on the true boundary. Raises MeshError for any other pair, an unknown boundary, or an element that folds.
    """
    wanted = find_kind(kind)
    curved = curved or {}
    require_boundaries(mesh, curved)
    if kind == mesh.kind:
        return mesh
    if mesh.kind != wanted.linear:
        raise MeshError(
            f"{mesh.source}: {mesh.kind} elements cannot become {kind}; give a mesh of {wanted.linear}"
        )
    points, cells = with_middle_nodes(mesh.points, mesh.cells, kind)
    straight = Mesh(points, kind, cells, mesh.boundaries, mesh.source)
    if not curved:
        return straight
    _project(points, straight.boundaries, curved)
    if kind in SERENDIPITY:
        _follow_edges(points, cells, kind)
        _project(points, straight.boundaries, curved)
    return replace(straight, points=points)


def with_middle_nodes(points: np.ndarray, cells: np.ndarray, kind: str) -> tuple[np.ndarray, np.ndarray]:
    """Points (n', d) and cells (m, a) of a quadratic kind, from those of the linear kind of the same shape.

    New nodes are numbered after the old ones: those of edges, then of faces, then of cells.
    """
    wanted = KINDS[kind]
    weights = shape_values(wanted.linear, wanted.reference_nodes[wanted.corners :])
    supports = [np.flatnonzero(row) for row in weights]
    all_points, columns, count = [points], [cells], len(points)
    for size in (2, 4, 8):
        local = [support for support in supports if len(support) == size]
        if local:
            corners = np.sort(cells[:, np.array(local)].reshape(-1, size), axis=1)
            unique, number = np.unique(corners, axis=0, return_inverse=True)
            all_points.append(points[unique].mean(axis=1))
            columns.append(count + number.reshape(len(cells), -1))
            count += len(unique)
    return np.concatenate(all_points), np.concatenate(columns, axis=1)


def _project(
    points: np.ndarray, boundaries: Mapping[str, np.ndarray], curved: Mapping[str, Projection]
) -> None:
    """Put the nodes of curved boundaries where their functions say."""
    for name, projection in curved.items():
        nodes = np.unique(boundaries[name])
        points[nodes] = projection(points[nodes])


def _follow_edges(points: np.ndarray, cells: np.ndarray, kind: str) -> None:
    """Put the nodes within faces and cells where the nodes of the edges, by their shape functions, put them."""
    outer = KINDS[SERENDIPITY[kind]]
    weights = shape_values(outer.name, KINDS[kind].reference_nodes[outer.nodes :])
    points[cells[:, outer.nodes :]] = np.einsum("ab,ebk->eak", weights, points[cells[:, : outer.nodes]])

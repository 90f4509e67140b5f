"""From linear to quadratic elements: nodes in the middle of edges, faces and cells."""

from collections.abc import Callable

import numpy as np

from core_models.errors import MeshError
from meshes.kinds import KINDS, find_kind
from meshes.mesh import Mesh
from meshes.shape_functions import shape_values


def elevate(mesh: Mesh, kind: str, move: Callable[[np.ndarray], np.ndarray] | None = None) -> Mesh:
    """The same body in quadratic elements of the same shape; corners keep their numbers.

    Middle nodes lie at the mean of the corners of their edge, face or cell.
    kind : 'quad8' or 'quad9' from quad4, 'tri6' from tri3, 'hex20' or 'hex27' from hex8, 'tet10' from tet4; the
    mesh's own kind gives it back. move : function of all node positions (n, d) that gives new ones, such as the
    projection of nodes onto a curved boundary. Raises MeshError for any other pair.
    """
    wanted = find_kind(kind)
    if kind == mesh.kind and move is None:
        return mesh
    if mesh.kind != wanted.linear:
        raise MeshError(
            f"{mesh.source}: {mesh.kind} elements cannot become {kind}; give a mesh of {wanted.linear}"
        )
    points, cells = with_middle_nodes(mesh.points, mesh.cells, kind)
    if move is not None:
        points = move(points)
    return Mesh(points, kind, cells, mesh.boundaries, mesh.source)


def with_middle_nodes(points: np.ndarray, cells: np.ndarray, kind: str) -> tuple[np.ndarray, np.ndarray]:
    """Points (n', d) and cells (m, a) of a quadratic kind, from those of the linear kind of the same shape.

    New nodes are numbered after the old ones: those of edges, then of faces, then of cells.
    """
    wanted = KINDS[kind]
    weights = shape_values(wanted.linear, wanted.reference_nodes)
    all_points, columns = [points], [cells]
    count = len(points)
    middle = range(wanted.corners, wanted.nodes)
    for size in (2, 4, 8):
        locals_ = [np.flatnonzero(weights[a]) for a in middle if np.count_nonzero(weights[a]) == size]
        if not locals_:
            continue
        supports = np.sort(cells[:, np.array(locals_)].reshape(-1, size), axis=1)
        unique, number = np.unique(supports, axis=0, return_inverse=True)
        all_points.append(points[unique].mean(axis=1))
        columns.append(count + number.reshape(len(cells), -1))
        count += len(unique)
    return np.concatenate(all_points), np.concatenate(columns, axis=1)

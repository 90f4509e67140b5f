"""Several bodies in one mesh."""

from collections.abc import Sequence

import numpy as np

from core_models.errors import MeshError
from meshes.mesh import Mesh


def join(meshes: Sequence[Mesh]) -> Mesh:
    """One mesh of several bodies that do not overlap; nodes and cells follow each other, body by body.

    Bodies may touch; they share no nodes. Boundaries of the same name become one.
    meshes : of one kind of element. Raises MeshError when there is none, when their kinds differ, or when two overlap,
    with the extents of the overlap.
    """
    if not meshes:
        raise MeshError("join: no mesh is given; give at least one")
    kinds = sorted({mesh.kind for mesh in meshes})
    if len(kinds) > 1:
        raise MeshError(
            f"join: the bodies consist of {', '.join(kinds)} elements; mesh them all with one kind"
        )
    starts = np.cumsum([0, *(len(mesh.points) for mesh in meshes[:-1])])
    named: dict[str, list[np.ndarray]] = {}
    for start, mesh in zip(starts, meshes, strict=True):
        for name, nodes in mesh.boundaries.items():
            named.setdefault(name, []).append(start + nodes)
    return Mesh(
        np.concatenate([mesh.points for mesh in meshes]),
        kinds[0],
        np.concatenate([start + mesh.cells for start, mesh in zip(starts, meshes, strict=True)]),
        {name: np.concatenate(parts) for name, parts in named.items()},
        source=" and ".join(mesh.source for mesh in meshes),
    )

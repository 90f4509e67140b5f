"""Named boundaries of a mesh: found among its facets, put in order, and asked for by name."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING

import numpy as np

from core_models.errors import MeshError
from core_models.names import suggestion
from meshes.facets import Facets, match, place

if TYPE_CHECKING:
    from meshes.mesh import Mesh

HOW_TO_NAME = 'name its facets in the mesh (gmsh: Physical Curve("...") or Physical Surface("..."))'


def require_boundaries(mesh: Mesh, names: Iterable[str]) -> None:
    """Raise MeshError, with the nearest name that is there, unless the mesh names all these boundaries."""
    for name in names:
        if name not in mesh.boundaries:
            raise MeshError(
                f"{mesh.source}: the boundary '{name}' is missing; {suggestion(name, mesh.boundaries)}; {HOW_TO_NAME}"
                if mesh.boundaries
                else f"{mesh.source}: the boundary '{name}' is missing: no boundary has a name; {HOW_TO_NAME}"
            )


def owned_facets(
    points: np.ndarray, facets: Facets, per_cell: int, named: Mapping[str, np.ndarray]
) -> dict[str, np.ndarray]:
    """For each name the cells and local facet numbers (k, 2) of its facets, in order.

    named : name -> (k, corners or more) nodes of facets, in any order and direction; a facet given twice counts once.
    In 2-D the facets of a name follow each other head to tail, piece by piece. Raises MeshError for a facet that is
    no facet of a cell or lies between two, and for a name without facets.
    """
    owners = {}
    for name, nodes in named.items():
        wanted = np.asarray(nodes)
        if (
            wanted.ndim != 2
            or wanted.shape[1] < facets.corners
            or len(wanted) == 0
            or wanted.dtype.kind not in "iu"
        ):
            raise MeshError(
                f"the boundary '{name}' has the shape {wanted.shape} and type {wanted.dtype}, not whole numbers "
                f"(k, {facets.nodes.shape[1]}) with k > 0; give the nodes of each facet, or leave the name out"
            )
        found = match(facets, wanted)
        for wrong, why in (
            (found < 0, "belongs to no cell"),
            (facets.uses[found] > 1, "is not on the rim: cells lie on both sides"),
        ):
            if wrong.any():
                where = _place(points, wanted[wrong.argmax(), : facets.corners])
                raise MeshError(f"the facet {where} of '{name}' {why}; take the name off it")
        found = found[np.sort(np.unique(found, return_index=True)[1])]
        if points.shape[1] == 2:
            found = found[head_to_tail(facets.nodes[found, :2])]
        owners[name] = np.column_stack(np.divmod(found, per_cell))
    return owners


def head_to_tail(pairs: np.ndarray) -> np.ndarray:
    """Order (k,) in which directed edges (k, 2) follow each other; pieces come in the order of their first edges."""
    leaving: dict[int, list[int]] = {}
    for number in range(len(pairs) - 1, -1, -1):
        leaving.setdefault(int(pairs[number, 0]), []).append(number)
    heads = np.flatnonzero(~np.isin(pairs[:, 0], pairs[:, 1])).tolist()
    done, order = np.zeros(len(pairs), dtype=bool), []
    for number in [*heads, *range(len(pairs))]:
        following = number
        while following is not None and not done[following]:
            done[following] = True
            order.append(following)
            candidates = leaving.get(int(pairs[following, 1]), [])
            while candidates and done[candidates[-1]]:
                candidates.pop()
            following = candidates[-1] if candidates else None
    return np.array(order, dtype=np.int64)


def _place(points: np.ndarray, nodes: np.ndarray) -> str:
    """Where a facet is, also when its nodes are not all there."""
    inside = (nodes >= 0) & (nodes < len(points))
    return place(points[nodes]) if inside.all() else f"of nodes {', '.join(map(str, nodes.tolist()))}"

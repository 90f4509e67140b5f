"""What a 2-D mesh must be to stand for a body of revolution about r = 0."""

from dataclasses import replace

import numpy as np

from core_models.errors import MeshError
from meshes.boundaries import require_boundaries
from meshes.facets import find_facets, place
from meshes.mesh import Mesh

ON_AXIS = 1e-9
"""Distance from r = 0, as a part of the largest radius, within which a node lies on the axis."""

BAR = ("foot", "side", "rear", "axis")
"""The boundaries of a bar, as they follow each other counter-clockwise."""


def axisymmetric(mesh: Mesh) -> Mesh:
    """The mesh as a body of revolution: coordinates (r, z) with r >= 0, and r = 0 exactly on the axis.

    Raises MeshError: not 2-D, nodes at r < 0, a boundary named 'axis' that is not exactly the facets on r = 0.
    """
    if mesh.dimension != 2:
        raise MeshError(f"{mesh.source}: is 3-D; give a mesh in the (r, z) plane for an axisymmetric body")
    points = mesh.points.copy()
    r = points[:, 0]
    near = np.abs(r) <= ON_AXIS * r.max()
    _check_axis(mesh, near)
    if r.min() < 0.0 and not near[r.argmin()]:
        raise MeshError(
            f"{mesh.source}: node {int(r.argmin())} has r = {r.min():g} m; move the body to r >= 0 (r is x, z is y)"
        )
    if (r[near] == 0.0).all():
        return mesh
    r[near] = 0.0
    return replace(mesh, points=points)


def check_bar(mesh: Mesh) -> None:
    """Raise MeshError unless foot, side, rear and axis are the whole rim of one body, each edge once, in this order.

    Counter-clockwise: foot from axis to rim, side from foot to rear, rear from rim to axis, axis from rear to foot.
    """
    require_boundaries(mesh, BAR)
    edges = [edge for name in BAR for edge in map(tuple, mesh.owners(name).tolist())]
    names = [name for name in BAR for _ in mesh.owners(name)]
    name_of: dict[tuple, str] = {}
    for edge, name, pair in zip(edges, names, _pairs(mesh), strict=True):
        if edge in name_of:
            where = f"the edge {place(mesh.points[pair])}"
            raise MeshError(f"{mesh.source}: {where} is in both '{name_of[edge]}' and '{name}'; keep one")
        name_of[edge] = name
    _check_whole(mesh)
    after = dict(_pairs(mesh).tolist())
    starts = {name: int(mesh.boundaries[name][0, 0]) for name in BAR}
    ends = {name: int(mesh.boundaries[name][-1, 1]) for name in BAR}
    followers = [next((n for n in BAR if starts[n] == ends[name]), "none") for name in BAR]
    if followers != [*BAR[1:], BAR[0]] or len(after) != len(edges):
        found = ", ".join(f"{b} after {a}" for a, b in zip(BAR, followers, strict=True))
        raise MeshError(
            f"{mesh.source}: the boundaries are not {', '.join(BAR)} one after the other, counter-clockwise "
            f"({found}); correct the names of the boundary edges"
        )


def _pairs(mesh: Mesh) -> np.ndarray:
    return np.concatenate([mesh.boundaries[name][:, :2] for name in BAR])


def _check_axis(mesh: Mesh, near: np.ndarray) -> None:
    """Raise MeshError unless a boundary named 'axis' holds the nodes near r = 0 and no others."""
    if "axis" not in mesh.boundaries:
        return
    marked = np.zeros(len(near), dtype=bool)
    marked[mesh.boundaries["axis"]] = True
    wrong = np.flatnonzero(marked != near)
    if len(wrong) == 0:
        return
    r, z = np.abs(mesh.points[marked]).T
    if z.max() <= ON_AXIS * np.abs(mesh.points).max() < r.max():
        raise MeshError(
            f"{mesh.source}: 'axis' lies on z = 0, not on r = 0: swap the coordinates (r is x, z is y)"
        )
    r, z = mesh.points[wrong[0]]
    state = "is in" if marked[wrong[0]] else "is not in"
    raise MeshError(
        f"{mesh.source}: node {wrong[0]} at (r, z) = ({r:.4g}, {z:.4g}) m {state} 'axis'; "
        "the axis is exactly the edges on r = 0 (r is x, z is y)"
    )


def _check_whole(mesh: Mesh) -> None:
    """Raise MeshError when an edge of the rim belongs to no boundary."""
    facets = find_facets(mesh.kind, mesh.points, mesh.cells)
    per_cell = len(facets.nodes) // len(mesh.cells)
    named = np.concatenate([mesh.owners(name) for name in BAR])
    missing = np.setdiff1d(facets.rim(), named @ [per_cell, 1])
    if len(missing):
        where = place(mesh.points[facets.nodes[missing[0], :2]])
        raise MeshError(
            f"{mesh.source}: the boundary edge {where} has no name; name it foot, side, rear or axis; "
            "if it is inside the body, merge nodes that coincide (gmsh: Coherence Mesh;)"
        )

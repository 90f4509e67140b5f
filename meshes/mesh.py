"""The mesh that both solvers are built from: elements of one kind, and boundaries by name."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from core_models.errors import MeshError
from meshes.bodies import check_bodies_apart
from meshes.boundaries import owned_facets
from meshes.facets import find_facets, place
from meshes.jacobians import smallest_scaled_jacobians
from meshes.kinds import KINDS, find_kind

FLAT = 1e-9
"""Scaled Jacobian at or below which an element counts as inverted or collapsed."""


@dataclass(frozen=True, eq=False)
class Mesh:
    """A body, or several, cut into elements of one kind; checked when it is made.

    points : (n, d) coordinates of the nodes [m]: (r, z), (x, y) or (x, y, z). kind : key of `meshes.kinds.KINDS`.
    cells : (m, a) node numbers in VTK's order, positively oriented. boundaries : name -> (k, b) nodes of facets, in
    any order and direction, of which the corners suffice; they become those of the facets' kind in VTK's order, seen
    from outside, in 2-D with the body on the left and head to tail. They need not cover the whole rim, and may
    overlap. source : what error messages call the mesh.
    Raises MeshError: points that are not finite, node numbers out of range, nodes that no cell uses, inverted or
    collapsed cells, cells that overlap at a facet, bodies that overlap, boundary facets of no cell or between two.
    """

    points: np.ndarray
    kind: str
    cells: np.ndarray
    boundaries: dict[str, np.ndarray]
    source: str = "mesh"
    _owners: dict[str, np.ndarray] = field(init=False, repr=False)

    def __post_init__(self) -> None:
        """Check everything and put it in its final form."""
        points = np.array(self.points, dtype=np.float64)
        cells = np.array(self.cells)
        try:
            kind = find_kind(self.kind)
            _check_points(points, kind.dimension)
            cells = _checked_cells(points, self.kind, cells)
            facets = find_facets(self.kind, points, cells)
            check_bodies_apart(points, self.kind, cells)
            owners = owned_facets(points, facets, len(kind.facets), self.boundaries)
        except MeshError as error:
            raise MeshError(f"{self.source}: {error}") from None
        local = np.array(kind.facets)
        boundaries = {name: cells[own[:, :1], local[own[:, 1]]] for name, own in owners.items()}
        for name, value in (
            ("points", points),
            ("cells", cells),
            ("boundaries", boundaries),
            ("_owners", owners),
        ):
            object.__setattr__(self, name, value)

    @property
    def dimension(self) -> int:
        """2 or 3."""
        return self.points.shape[1]

    def owners(self, name: str) -> np.ndarray:
        """Cell and local facet number (k, 2) of each facet of a boundary, in the boundary's order."""
        return self._owners[name]

    def corners(self) -> np.ndarray:
        """Coordinates (m, c, d) [m] of the vertices of the cells."""
        return self.points[self.cells[:, : KINDS[self.kind].corners]]


def check_mesh(mesh: Any) -> None:
    """Refuse what is no mesh; MeshError."""
    if not isinstance(mesh, Mesh):
        raise MeshError(
            f"mesh = {mesh!r} is no mesh: give a meshes.mesh.Mesh, for example of meshes.block.block"
        )


def _check_points(points: np.ndarray, dimension: int) -> None:
    """Raise MeshError unless the points are finite and have as many coordinates as the elements' dimension."""
    if points.ndim != 2 or points.shape[1] != dimension or len(points) == 0:
        raise MeshError(
            f"points have the shape {points.shape}, not (n, {dimension}); give {dimension} coordinates of each node"
        )
    finite = np.isfinite(points).all(axis=1)
    if not finite.all():
        node = int(finite.argmin())
        raise MeshError(f"node {node} has the coordinates {points[node].tolist()}; give finite numbers")


def _checked_cells(points: np.ndarray, name: str, cells: np.ndarray) -> np.ndarray:
    """The cells as whole numbers; MeshError unless they use every node and none is inverted or collapsed."""
    nodes = KINDS[name].nodes
    if cells.ndim != 2 or cells.shape[1] != nodes or len(cells) == 0 or cells.dtype.kind not in "iu":
        raise MeshError(
            f"cells have the shape {cells.shape} and type {cells.dtype}, not whole numbers (m, {nodes}) with m > 0; "
            f"give {nodes} nodes per {name} element"
        )
    cells = cells.astype(np.int64)
    if cells.min() < 0 or cells.max() >= len(points):
        element = int(((cells < 0) | (cells >= len(points))).any(axis=1).argmax())
        raise MeshError(f"element {element} uses a node that is not there (nodes are 0 to {len(points) - 1})")
    uses = np.bincount(cells.ravel(), minlength=len(points))
    if uses.min() == 0:
        raise MeshError(f"node {int(uses.argmin())} belongs to no element; remove it")
    bad = smallest_scaled_jacobians(name, points, cells) <= FLAT
    if bad.any():
        raise MeshError(_describe_inverted(points, name, cells, np.flatnonzero(bad)))
    return cells


def _describe_inverted(points: np.ndarray, name: str, cells: np.ndarray, bad: np.ndarray) -> str:
    """Say which element is inverted, where it is, how many there are and what to do."""
    cell = cells[bad[0]][None]
    total = "the only one" if len(bad) == 1 else f"the first of {len(bad)}"
    backwards = smallest_scaled_jacobians(name, points, _mirrored(name, cell))[0] > FLAT
    if backwards:
        state = "numbered clockwise" if points.shape[1] == 2 else "numbered inside out"
        remedy = "reverse its nodes (gmsh: Reverse Surface, or Mesh.reverse)"
    else:
        state, remedy = "inverted or collapsed", "move or remesh its nodes"
    return f"element {bad[0]} (counted from 0; {total}) {place(points[cell[0]])} is {state}; {remedy}"


def _mirrored(name: str, cells: np.ndarray) -> np.ndarray:
    """The cells with two reference directions exchanged, which changes the sign of their volume."""
    nodes = KINDS[name].reference_nodes
    swapped = nodes[:, [1, 0, *range(2, nodes.shape[1])]]
    order = [int(np.abs(nodes - place_).max(axis=1).argmin()) for place_ in swapped]
    return cells[:, order]

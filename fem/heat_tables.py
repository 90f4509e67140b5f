"""Tables of the temperature's finite element space: linear in every kind of element, with nodes at its corners."""

from typing import NamedTuple

import numpy as np

from core_models.geometry import Geometry
from fem.elements import Element, Sized
from fem.facets import BoundaryFacets
from fem.reference import shape_functions
from fem.tables import Space
from meshes.kinds import FACET_NODES, KINDS
from meshes.mesh import Mesh


class HeatTables(NamedTuple):
    """What the kernels need of the space; a - the corners of an element, q - its points.

    nodes : (m, a). shape : (q, a) shape functions at the points. gradients : (m, q, a, d) their reference gradients
    [1/m]. weights : (m, q) reference volumes of the points [m^3].
    """

    nodes: np.ndarray
    shape: np.ndarray
    gradients: np.ndarray
    weights: np.ndarray


def heat_tables(mesh: Mesh, geometry: Geometry, space: Space) -> HeatTables:
    """The space for the temperature of the points of another space on the same mesh.

    Linear functions on quadratic elements too: their row sums are positive, so that the lumped capacities are those of
    the points' heat, and what the points take is what the nodes have.
    """
    kind, tables = KINDS[mesh.kind], space.tables
    shape, local = shape_functions(kind.linear, space.places)
    if kind.degree == 1:
        gradients = tables.gradients[..., : mesh.dimension]
    else:
        _, mapping = shape_functions(mesh.kind, space.places)
        jacobian = mesh.points[mesh.cells].transpose(0, 2, 1)[:, None] @ mapping
        gradients = local @ np.linalg.inv(jacobian)
    return HeatTables(
        np.ascontiguousarray(mesh.cells[:, : kind.corners]),
        shape,
        np.ascontiguousarray(gradients),
        tables.weights,
    )


def heat_element(mesh: Mesh, element: Element) -> Element:
    """The element as kernels see it, with its corners for nodes."""
    return Sized(KINDS[mesh.kind].corners, element.points) if isinstance(element, Sized) else element


def corner_facets(mesh: Mesh, name: str) -> np.ndarray:
    """Node numbers (k, b) of the corners of the facets on a boundary."""
    facet = KINDS[KINDS[mesh.kind].linear].facet
    return mesh.boundaries[name][:, : len(FACET_NODES[facet])]


def boundary_shares(mesh: Mesh, name: str, geometry: Geometry) -> np.ndarray:
    """Reference area (n,) [m^2] of a boundary that belongs to each node: the integral of its shape function."""
    facets = BoundaryFacets(mesh, name, geometry)
    shape, _ = shape_functions(KINDS[KINDS[mesh.kind].linear].facet, facets.places)
    nodes = corner_facets(mesh, name).ravel()
    return np.bincount(nodes, weights=(facets.areas @ shape).ravel(), minlength=len(mesh.points))

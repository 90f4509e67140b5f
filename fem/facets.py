"""Quadrature on a named boundary: reference areas, current normals, and nodal forces from both."""

import numpy as np

from core_models.geometry import Axisymmetric, Geometry
from fem.reference import rule, shape_functions
from meshes.kinds import KINDS
from meshes.mesh import Mesh

_DEGREE = 5


class BoundaryFacets:
    """The facets of a named boundary.

    nodes : (k, b) node numbers. positions : (k, q, d) reference positions of the points [m]. areas : (k, q) reference
    areas that they weigh [m^2]: 2 pi R per length in the axisymmetric body, those of unit thickness in plane strain.
    places : (q, d - 1) reference coordinates of the points on a facet. shape : (q, b) shape functions there.
    """

    def __init__(self, mesh: Mesh, name: str, geometry: Geometry) -> None:
        facet = KINDS[mesh.kind].facet
        self.places, self._weights = rule(facet, _DEGREE)
        self.shape, self._local = shape_functions(facet, self.places)
        self._axisymmetric = isinstance(geometry, Axisymmetric)
        self.nodes = mesh.boundaries[name]
        self.positions = np.einsum("qb,kbi->kqi", self.shape, mesh.points[self.nodes])
        self.areas = np.linalg.norm(self.normals(mesh.points), axis=2)

    def normals(self, x: np.ndarray) -> np.ndarray:
        """Outward normals times the areas of the points (k, q, d) [m^2] for nodes at x (n, d) [m]."""
        corners = x[self.nodes]
        along = np.einsum("qbj,kbi->jkqi", self._local, corners)
        if len(along) == 1:
            normals = np.stack([along[0, ..., 1], -along[0, ..., 0]], axis=-1)
        else:
            normals = np.cross(along[0], along[1])
        normals *= self._weights[:, None]
        if self._axisymmetric:
            normals *= 2.0 * np.pi * np.einsum("qb,kb->kq", self.shape, corners[..., 0])[..., None]
        return normals

    def normal_slopes(self, x: np.ndarray) -> np.ndarray:
        """d normals / d x of the facets' own nodes, (k, q, d, b, d) [m]."""
        corners = x[self.nodes]
        along = np.einsum("qbj,kbi->jkqi", self._local, corners)
        local = self._local * self._weights[:, None, None]
        dimension = x.shape[1]
        slopes = np.zeros((*along.shape[1:], self.nodes.shape[1], dimension))
        if dimension == 2:
            slopes[:, :, 0, :, 1] = local[..., 0]
            slopes[:, :, 1, :, 0] = -local[..., 0]
        else:
            for j, axis in enumerate(np.eye(3)):
                first = np.cross(axis, along[1])[:, :, :, None] * local[:, None, :, 0]
                second = np.cross(along[0], axis)[:, :, :, None] * local[:, None, :, 1]
                slopes[..., j] = first + second
        if self._axisymmetric:
            radius = np.einsum("qb,kb->kq", self.shape, corners[..., 0])
            plane = np.stack([along[0, ..., 1], -along[0, ..., 0]], axis=-1) * self._weights[:, None]
            slopes *= radius[..., None, None, None]
            slopes[..., 0] += plane[..., None] * self.shape[:, None, :]
            slopes *= 2.0 * np.pi
        return slopes

    def add(self, forces: np.ndarray, at_points: np.ndarray) -> None:
        """Add forces (k, q, d) [N] at the points to the nodal forces (n, d) [N]."""
        shares = np.einsum("qb,kqi->kbi", self.shape, at_points)
        flat = self.nodes.ravel()
        for i in range(forces.shape[1]):
            forces[:, i] += np.bincount(flat, weights=shares[..., i].ravel(), minlength=len(forces))

"""Points on a boundary that loads and supports act at: the middles of the particles' faces."""

import numpy as np

from core_models.geometry import Axisymmetric, Geometry
from meshes.facets import facet_vectors
from mpm.configurations import Total, Updated
from mpm.particles import Faces, Particles
from mpm.shape import deformed


class Surface:
    """The faces along one boundary, with their middles and areas.

    Parameters
    ----------
    faces : of the boundary. particles : all of them, in the reference body.

    particles : (k,) numbers of the particles whose faces they are. reference_points (k, d) [m], reference_vectors
    (k, d) : outward normals in the reference body, as long as the areas, reference_areas (k,) [m^2].
    """

    def __init__(self, faces: Faces, particles: Particles, geometry: Geometry) -> None:
        self.particles, self._corners = faces.particles, faces.corners
        self._middles = _middles(faces.corners)
        self._revolved = isinstance(geometry, Axisymmetric)
        self.reference_points = particles.positions[faces.particles] + self._middles[:, 0]
        self.reference_vectors = self._vectors(faces.corners, self.reference_points)
        self.reference_areas = np.linalg.norm(self.reference_vectors, axis=1)
        self._thickness = (
            self.reference_vectors * (particles.volumes[faces.particles] / self.reference_areas**2)[:, None]
        )

    def points(self, positions: np.ndarray, deformation_gradient: np.ndarray) -> np.ndarray:
        """Current middles (k, d) [m] of the faces."""
        return deformed(self.particles, self._middles, positions, deformation_gradient)[:, 0]

    def places(
        self, configuration: Updated | Total, positions: np.ndarray, deformation_gradient: np.ndarray
    ) -> np.ndarray:
        """Where the middles (k, d) [m] lie in the body that the grid covers."""
        if isinstance(configuration, Total):
            return self.reference_points
        return self.points(positions, deformation_gradient)

    def thickness(self, configuration: Updated | Total, deformation_gradient: np.ndarray) -> np.ndarray:
        """Vectors (k, d) [m] through the particles' domains to the faces, in the body that the grid covers."""
        if isinstance(configuration, Total):
            return self._thickness
        d = self._thickness.shape[1]
        return np.einsum("kij,kj->ki", deformation_gradient[self.particles, :d, :d], self._thickness)

    def area_vectors(
        self, points: np.ndarray, positions: np.ndarray, deformation_gradient: np.ndarray
    ) -> np.ndarray:
        """Current outward normals (k, d) of the faces, as long as their areas [m^2]; `points` are their middles."""
        corners = deformed(self.particles, self._corners, positions, deformation_gradient)
        return self._vectors(corners, points)

    def _vectors(self, corners: np.ndarray, points: np.ndarray) -> np.ndarray:
        vectors = facet_vectors(corners)
        return 2.0 * np.pi * points[:, :1] * vectors if self._revolved else vectors


def _middles(corners: np.ndarray) -> np.ndarray:
    """Middles (k, 1, d) of faces with corners (k, c, d): of area, also where two corners of a quad coincide."""
    if corners.shape[1] == 2:
        return corners.mean(axis=1, keepdims=True)
    halves = np.stack([corners[:, [0, 1, 2]], corners[:, [0, 2, 3]]], axis=1)
    areas = np.linalg.norm(
        np.cross(halves[:, :, 1] - halves[:, :, 0], halves[:, :, 2] - halves[:, :, 0]), axis=2
    )
    share = areas / areas.sum(axis=1, keepdims=True)
    return np.einsum("kh,khi->ki", share, halves.mean(axis=2))[:, None]

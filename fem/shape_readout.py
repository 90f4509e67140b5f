"""What can be read from the shape of a body of finite elements, whatever moves it."""

import numpy as np

from core_models.errors import SceneError, UnsupportedError
from core_models.geometry import Axisymmetric
from core_models.names import suggestion
from fem.domains import domain_shape
from fem.shape import chain, outline


class ShapeReadout:
    """Positions, volumes and outlines: what explicit and implicit solvers have in common."""

    @property
    def nodal_mass(self) -> np.ndarray:
        """Lumped mass (n,) [kg]."""
        return self._body.nodal_mass

    def boundary_positions(self, name: str) -> np.ndarray:
        """Positions (k, d) [m] of the nodes of a boundary, in two dimensions along it; SceneError if unknown."""
        if name not in self.mesh.boundaries:
            raise SceneError(f"the mesh has no boundary {name!r}; {suggestion(name, self.mesh.boundaries)}")
        facets = self.mesh.boundaries[name]
        return self.positions[chain(facets) if self.mesh.dimension == 2 else np.unique(facets)]

    def boundary_points(self, name: str) -> tuple[np.ndarray, np.ndarray]:
        """Reference and current positions (k, d) [m] of the nodes of a boundary; SceneError if unknown."""
        current = self.boundary_positions(name)
        facets = self.mesh.boundaries[name]
        return self.mesh.points[chain(facets) if self.mesh.dimension == 2 else np.unique(facets)], current

    @property
    def reference_positions(self) -> np.ndarray:
        """Positions of the points in the reference body (n, d) [m]."""
        return self._at_points(self.mesh.points)

    def point_positions(self) -> np.ndarray:
        """Positions of the points (n, d) [m]."""
        return self._at_points(self.positions)

    def _at_points(self, nodal: np.ndarray) -> np.ndarray:
        corners = nodal[self.mesh.cells]
        return np.einsum("qa,eai->eqi", self._body.space.shape, corners).reshape(-1, corners.shape[2])

    def point_volumes(self) -> np.ndarray:
        """Current volumes of the points (n,) [m^3]."""
        volumes = self.points.reference_volumes * self.points.volume_ratio
        return volumes if self._body.scales is None else volumes / self._body.scales**3

    def domains(self) -> np.ndarray:
        """The deformed part of the body round each point: quads (n, 4, 2) or hexahedra (n, 8, 3) [m]."""
        shape = domain_shape(self.mesh.kind, self._body.space.places)
        corners = np.einsum("qca,eai->eqci", shape, self.positions[self.mesh.cells])
        return corners.reshape(-1, *corners.shape[2:])

    def outline(self) -> dict[str, np.ndarray]:
        """Deformed boundaries by name, each a line (k, 2) [m], without the axis; UnsupportedError in 3-D."""
        if self.mesh.dimension == 3:
            raise UnsupportedError("a 3-D body has no outline: use boundary_positions(name)")
        on_axis = self.mesh.points[:, 0] == 0.0 if isinstance(self.geometry, Axisymmetric) else None
        return outline(self.mesh.boundaries, self.positions, on_axis)

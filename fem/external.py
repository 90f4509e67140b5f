"""Forces on the nodes from outside: body forces, tractions and pressures."""

import numpy as np

from core_models.geometry import Geometry
from core_models.loads import REFERENCE, BodyForce, Load, Pressure, Traction, at_points, at_time
from fem.facets import BoundaryFacets
from meshes.mesh import Mesh


class ExternalForces:
    """Nodal forces of the loads on a body.

    A body force acts on the lumped mass of each node, so a uniform one accelerates the body exactly uniformly.
    Tractions that do not depend on time are integrated once.
    """

    def __init__(
        self, loads: tuple[Load, ...], mesh: Mesh, geometry: Geometry, nodal_mass: np.ndarray
    ) -> None:
        self._reference, self._mass = mesh.points, nodal_mass[:, None]
        self._bodies = [load for load in loads if isinstance(load, BodyForce)]

        def on_boundaries(load_class: type) -> list[tuple]:
            found = [load for load in loads if isinstance(load, load_class)]
            return [(load, BoundaryFacets(mesh, load.boundary, geometry)) for load in found]

        self._pressures, tractions = on_boundaries(Pressure), on_boundaries(Traction)
        self._constant = np.zeros_like(mesh.points)
        for load, facets in tractions:
            if not callable(load.traction):
                self._add_traction(self._constant, load, facets, 0.0)
        self._varying = [(load, facets) for load, facets in tractions if callable(load.traction)]
        self._present = bool(self._bodies or self._pressures or tractions)

    def at(self, x: np.ndarray, time: float) -> np.ndarray | None:
        """Forces (n, d) [N] on nodes at x (n, d) [m] at a time [s]; None if nothing acts."""
        if not self._present:
            return None
        forces = self._constant.copy()
        for load in self._bodies:
            places = self._reference if load.at == REFERENCE else x
            forces += self._mass * at_points(load.function, places, time, x.shape[1])
        for load, facets in self._varying:
            self._add_traction(forces, load, facets, time)
        for load, facets in self._pressures:
            facets.add(forces, -at_time(load.pressure, time) * facets.normals(x))
        return forces

    def _add_traction(self, forces: np.ndarray, load: Traction, facets: BoundaryFacets, time: float) -> None:
        places = facets.positions.reshape(-1, forces.shape[1])
        traction = at_points(load.traction, places, time, forces.shape[1]).reshape(facets.positions.shape)
        facets.add(forces, traction * facets.areas[..., None])

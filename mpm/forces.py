"""Forces from outside: body forces at the particles, tractions and pressures at the middles of their faces."""

from collections.abc import Callable

import numpy as np

from core_models.geometry import Geometry
from core_models.loads import REFERENCE, BodyForce, Load, Pressure, Traction, at_points, at_time
from mpm.anchors import Anchors
from mpm.background import Background
from mpm.particles import Particles
from mpm.surface import Surface


class Forces:
    """The forces among the loads.

    Parameters
    ----------
    loads : of `core_models.loads`. particles : in the reference body. density : [kg/m^3].
    """

    def __init__(
        self, loads: tuple[Load, ...], particles: Particles, geometry: Geometry, density: float
    ) -> None:
        self._body = [load for load in loads if isinstance(load, BodyForce)]
        self._surface = [
            (load, Surface(particles.faces[load.boundary], particles, geometry))
            for load in loads
            if isinstance(load, Traction | Pressure)
        ]
        self._particles, self._density = particles, density
        self._on_particles: np.ndarray | None = None
        self._on_surface: list[tuple[Anchors, np.ndarray]] = []

    def on_particles(self, time: float, positions: np.ndarray) -> np.ndarray | None:
        """Body forces on the particles (n, d) [N], or None where there are none."""
        if not self._body:
            return None
        masses = self._density * self._particles.volumes
        self._on_particles = np.zeros_like(positions)
        for load in self._body:
            places = self._particles.positions if load.at == REFERENCE else positions
            self._on_particles += masses[:, None] * at_points(load.function, places, time, places.shape[1])
        return self._on_particles

    def load_surfaces(
        self,
        background: Background,
        time: float,
        places: np.ndarray,
        positions: np.ndarray,
        deformation_gradient: np.ndarray,
    ) -> None:
        """Add the forces on the surface to the grid.

        places : of the particles (n, d) in the body that the grid covers; positions : in the deformed one [m].
        """
        self._on_surface = []
        for load, surface in self._surface:
            if isinstance(load, Pressure):
                points = surface.points(positions, deformation_gradient)
                vectors = surface.area_vectors(points, positions, deformation_gradient)
                forces = -at_time(load.pressure, time) * vectors
            else:
                traction = at_points(load.traction, surface.reference_points, time, positions.shape[1])
                forces = surface.reference_areas[:, None] * traction
            anchors = background.anchors_through(
                surface.places(background.configuration, positions, deformation_gradient),
                surface.particles,
                places,
                surface.thickness(background.configuration, deformation_gradient),
            )
            for axis in range(forces.shape[1]):
                anchors.load(axis, forces[:, axis])
            self._on_surface.append((anchors, forces))

    def power_before(self, velocities: np.ndarray) -> float:
        """Power of the forces [W] on the velocities that they find: (n, d) [m/s] of the particles, and the grid's."""
        return self._power(velocities, Anchors.before)

    def power(self, moves: np.ndarray) -> float:
        """Power of the forces [W] while the particles move with velocities (n, d) [m/s] and the grid with its own."""
        return self._power(moves, Anchors.after)

    def _power(self, velocities: np.ndarray, of_grid: Callable[[Anchors, int], np.ndarray]) -> float:
        power = 0.0 if self._on_particles is None else float((self._on_particles * velocities).sum())
        for anchors, forces in self._on_surface:
            power += sum(
                float((forces[:, axis] * of_grid(anchors, axis)).sum()) for axis in range(forces.shape[1])
            )
        return power

"""Heat conduction in a body of particles; equations in `core_models.conduction`.

The grid is filled anew in each step, with the temperatures of the particles and the slopes that they carry; boundaries
act at the middles of the particles' faces. Bodies that share nodes share heat.
"""

import numpy as np

from core_models.conduction import Capacities, check_conduction, held_temperature, thermal_loads
from core_models.geometry import Geometry
from core_models.loads import Load, at_time
from core_models.points import MaterialPoints
from mpm.anchors import Anchors
from mpm.background import Background
from mpm.grid import VELOCITY, block_nodes, clear
from mpm.heat_flow import (
    CAPACITY,
    FLOW,
    RISE,
    TEMPERATURE,
    conduct,
    gather_heat,
    mirror,
    settle_heat,
    warm_nodes,
    warm_particles,
)
from mpm.particles import Particles
from mpm.surface import Surface


class Conduction:
    """Heat between the particles, by way of the grid, and the boundaries.

    Parameters
    ----------
    loads : of `core_models.loads`. particles : in the reference body. points : their states. cell_size : h [m].

    gradients : (n, d) of the temperature at the particles [K/m].
    limit : stable step h^2 / (2 d k) rho c / J of the fastest particle, from the last step on [s].
    Raises MaterialError for a material that cannot conduct, SceneError for thermal loads that cannot be.
    """

    def __init__(
        self,
        loads: tuple[Load, ...],
        particles: Particles,
        geometry: Geometry,
        points: MaterialPoints,
        cell_size: float,
    ) -> None:
        check_conduction(points.material)
        self._points, self._conductivity = points, points.material.thermal_conductivity
        held, fluxes = thermal_loads(loads)

        def on_boundaries(found: list) -> list[tuple]:
            return [(load, Surface(particles.faces[load.boundary], particles, geometry)) for load in found]

        self._held, self._fluxes = on_boundaries(held), on_boundaries(fluxes)
        self._capacities = Capacities(points)
        self.gradients = np.zeros_like(particles.positions)
        self._field = np.zeros(0)
        self._square = cell_size**2 / (2.0 * self.gradients.shape[1])
        self._measure(self._capacities.fill(points.old.temperature), points.volume_ratio)

    def _measure(self, capacities: np.ndarray, volume_ratio: np.ndarray) -> None:
        """Find the stable step."""
        volumes = self._points.reference_volumes * volume_ratio
        self.limit = self._square / (self._conductivity * float((volumes / capacities).max()))

    def advance(
        self,
        background: Background,
        dt: float,
        time: float,
        positions: np.ndarray,
        deformation_gradient: np.ndarray,
        volume_ratio: np.ndarray,
    ) -> float:
        """Conduct heat for dt [s] from a time [s], after the points have accepted the rest of the step.

        background : as filled in this step. positions (n, d) [m], deformation_gradient (n, 3, 3) : before the step.
        Returns the heat that has come in [J].
        """
        points, threads, geometry = self._points, background.threads, background.geometry
        before, count = points.new.temperature, background.blocks * block_nodes(geometry)
        if len(self._field) < VELOCITY * count:
            self._field = np.zeros(len(background.grid.after))
        field, capacities = self._field, self._capacities.fill(before)
        threads.run(clear, background.blocks, field, VELOCITY * block_nodes(geometry))
        background.by_colour(gather_heat, positions, capacities, before, self.gradients, field)
        self._mirror(background, (TEMPERATURE, CAPACITY), False)
        threads.run(settle_heat, background.blocks, geometry, field)
        self._mirror(background, (TEMPERATURE,), True)
        background.by_colour(
            conduct,
            positions,
            self._conductivity,
            points.reference_volumes,
            volume_ratio,
            self.gradients,
            field,
        )
        self._mirror(background, (FLOW,), False)
        heat = self._let_in(background, dt, time + 0.5 * dt, positions, deformation_gradient)
        threads.run(warm_nodes, background.blocks, geometry, dt, field)
        heat += self._hold(background, dt, time + dt, positions, deformation_gradient)
        self._mirror(background, (RISE,), True)
        background.over_homes(
            warm_particles, positions, before, self._decay(dt), field, points.old.temperature
        )
        self._measure(capacities, volume_ratio)
        return heat

    def _decay(self, dt: float) -> float:
        """Part of what nodes do not see that goes within dt [s], at the rate k / (rho c h^2) of the fastest particle.

        It is the same for all particles: then what they part with sums to nothing.
        """
        return min(dt / (2.0 * self.gradients.shape[1] * self.limit), 1.0)

    def _mirror(self, background: Background, columns: tuple[int, ...], back: bool) -> None:
        """Fold columns of the field from beyond symmetry planes onto their images, or copy them back."""
        pairs = reversed(background.pairs) if back else background.pairs
        for pair in pairs:
            for column in columns:
                mirror(background.geometry, background.grid, *pair, self._field, column, back)

    @property
    def _records(self) -> np.ndarray:
        return self._field.reshape(-1, VELOCITY)

    def _let_in(
        self,
        background: Background,
        dt: float,
        time: float,
        positions: np.ndarray,
        deformation_gradient: np.ndarray,
    ) -> float:
        """Add the flux through boundaries to the flow into the nodes; returns its heat within dt [J]."""
        heat = 0.0
        for load, surface in self._fluxes:
            flow = at_time(load.flux, time) * surface.reference_areas
            anchors = background.anchors(surface.points(positions, deformation_gradient))
            self._records[anchors.nodes, FLOW] += anchors.spread_evenly(flow)
            heat += dt * float(flow.sum())
        return heat

    def _hold(
        self,
        background: Background,
        dt: float,
        time: float,
        positions: np.ndarray,
        deformation_gradient: np.ndarray,
    ) -> float:
        """Give heat at boundaries so that they take their temperatures at a time [s]; returns it [J].

        The temperature of a face is that of its particle, extended by its slope. Heat at faces warms nodes, and these
        the particles; each face gets what it would need if all faces needed as much, so what is missing shrinks from
        step to step. The nodes' own temperature at a face would not do: light nodes take it with next to no heat.
        """
        if not self._held:
            return 0.0
        faces = [surface.points(positions, deformation_gradient) for _, surface in self._held]
        particles = np.concatenate([surface.particles for _, surface in self._held])
        wanted = np.repeat(
            [held_temperature(load, time) for load, _ in self._held], [len(places) for places in faces]
        )
        places = np.concatenate(faces)
        at_faces, at_particles = background.anchors(places), background.anchors(positions[particles])
        heats = (
            wanted - self._found(at_particles, particles, places - positions[particles], dt)
        ) / self._answer(at_faces, at_particles)
        self._records[at_faces.nodes, RISE] += self._warming(at_faces, heats)
        return float(heats.sum())

    def _found(self, anchors: Anchors, particles: np.ndarray, offsets: np.ndarray, dt: float) -> np.ndarray:
        """Temperatures (k,) [K] that faces at offsets (k, d) [m] from their particles would have at the step's end."""
        records, points = self._records, self._points
        rest = points.new.temperature[particles] - anchors.even(records[:, TEMPERATURE])
        own = points.old.temperature[particles] + anchors.even(records[:, RISE]) - self._decay(dt) * rest
        return own + (self.gradients[particles] * offsets).sum(axis=1)

    def _answer(self, at_faces: Anchors, at_particles: Anchors) -> np.ndarray:
        """Rises (k,) of the particles' temperatures [K] for 1 J given at every face."""
        # The flow into the nodes has been used: its column holds their rises.
        column = self._records[:, FLOW]
        column[at_particles.nodes] = 0.0
        column[at_faces.nodes] = self._warming(at_faces, np.ones(len(at_faces)))
        return at_particles.even(column)

    def _warming(self, anchors: Anchors, heats: np.ndarray) -> np.ndarray:
        """Rises of the temperatures of the nodes [K] for heat given at points (k,) [J]."""
        return anchors.spread_evenly(heats) / self._records[anchors.nodes, CAPACITY]

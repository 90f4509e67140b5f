"""Heat conduction in a body of particles; equations in `core_models.conduction`.

The grid is filled anew in each step, with the temperatures of the particles and the slopes that they carry; boundaries
act at the middles of the particles' faces, as supports do (`mpm.supports`). Bodies that share nodes share heat.
"""

import numpy as np

from core_models.conduction import Capacities, check_conduction, thermal_loads
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
from mpm.supports import solve
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
            return [
                (load, Surface(particles.faces[load.boundary], particles.positions, geometry))
                for load in found
            ]

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
        heat += self._hold(background, time + dt, positions, deformation_gradient)
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

    def _column(self, anchors: Anchors, column: int) -> np.ndarray:
        return self._field.reshape(-1, VELOCITY)[anchors.nodes, column]

    def _add(self, anchors: Anchors, column: int, values: np.ndarray) -> None:
        self._field.reshape(-1, VELOCITY)[anchors.nodes, column] += values

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
            self._add(anchors, FLOW, anchors.spread_evenly(flow))
            heat += dt * float(flow.sum())
        return heat

    def _hold(
        self, background: Background, time: float, positions: np.ndarray, deformation_gradient: np.ndarray
    ) -> float:
        """Change the nodes' rises so that boundaries take their temperatures at a time [s]; returns the heat [J]."""
        if not self._held:
            return 0.0
        points = [surface.points(positions, deformation_gradient) for _, surface in self._held]
        wanted = np.concatenate(
            [
                np.full(len(p), at_time(load.temperature, time))
                for (load, _), p in zip(self._held, points, strict=True)
            ]
        )
        anchors = background.anchors(np.concatenate(points))
        found = anchors.even(self._column(anchors, TEMPERATURE) + self._column(anchors, RISE))
        capacities = self._column(anchors, CAPACITY)
        heats = solve(_Response(anchors, capacities), 0, wanted - found)
        self._add(anchors, RISE, anchors.spread_evenly(heats) / capacities)
        return float(heats.sum())


class _Response:
    """How temperatures at points (k,) answer to heat given there: what `solve` asks of anchors."""

    def __init__(self, anchors: Anchors, capacities: np.ndarray) -> None:
        self._anchors, self._capacities = anchors, capacities

    def response(self, _axis: int, heats: np.ndarray) -> np.ndarray:
        """Rises of the temperature at the points (k,) [K] for heat given there (k,) [J]."""
        return self._anchors.even(self._anchors.spread_evenly(heats) / self._capacities)

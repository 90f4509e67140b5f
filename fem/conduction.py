"""Heat conduction in a body of finite elements; equations in `core_models.conduction`.

The nodes keep their temperatures: the lumped finite element solution, which also gains what the points gain in the rest
of a step. Boundaries act on the nodes.
"""

import numpy as np

from core_models.conduction import Capacities, check_conduction, held_temperature, thermal_loads
from core_models.geometry import Geometry, PlaneStrain
from core_models.loads import Load, at_time
from core_models.points import MaterialPoints
from fem.body import Body
from fem.deformation import ELEMENT_CHUNK
from fem.elements import find_element
from fem.heat_flow import COLUMNS, conduct, warm_nodes, warm_points
from fem.heat_tables import boundary_shares, corner_facets, heat_element, heat_tables
from fem.metric import make_metric
from fem.motion import NODE_CHUNK
from fem.tables import elements_round_nodes
from meshes.mesh import Mesh


class Conduction:
    """The temperatures of the nodes, and heat between them, the points and the boundaries.

    limit : step in which no part of the temperature changes its sign, 1 / highest rate [s].
    Raises MaterialError for a material that cannot conduct, SceneError for thermal loads that cannot be.
    """

    def __init__(
        self,
        mesh: Mesh,
        geometry: Geometry,
        integration: str,
        body: Body,
        points: MaterialPoints,
        loads: tuple[Load, ...],
    ) -> None:
        check_conduction(points.material)
        self._points, self._body, self._threads = points, body, points.threads
        # Temperature has no component round the axis: in the plane the gradient is that of plane strain.
        self._geometry = geometry if mesh.dimension == 3 else PlaneStrain()
        self._element = heat_element(mesh, find_element(mesh.kind, integration))
        self._tables = heat_tables(mesh, geometry, body.space)
        self._capacities = Capacities(points)
        count, cells = len(mesh.points), self._tables.nodes
        mass = points.material.density * self._tables.weights @ self._tables.shape
        self._metric = make_metric(self._tables, mass, self._geometry, mesh.points, None)
        self._round = elements_round_nodes(cells, count)
        self._corners = np.zeros((*cells.shape, COLUMNS))
        self._residues, self._rises = np.zeros(points.n), np.zeros(count)
        self._rates = np.zeros(-(-len(cells) // ELEMENT_CHUNK))
        self._supplied = np.zeros(-(-count // NODE_CHUNK))
        self._boundaries(mesh, geometry, loads)
        self.start()

    def _boundaries(self, mesh: Mesh, geometry: Geometry, loads: tuple[Load, ...]) -> None:
        held, fluxes = thermal_loads(loads)
        count = len(mesh.points)
        self._held_by = [(load, np.unique(corner_facets(mesh, load.boundary))) for load in held]
        self._fluxes = [(load, boundary_shares(mesh, load.boundary, geometry)) for load in fluxes]
        times_held = np.zeros(count)
        for _, nodes in self._held_by:
            times_held[nodes] += 1.0
        self._held, self._times_held = times_held > 0.0, np.maximum(times_held, 1.0)

    def start(self) -> None:
        """Temperatures of the nodes from those of the points, and the first limit of the step."""
        temperature, cells = self._points.old.temperature, self._tables.nodes
        parts = self._capacities.fill(temperature).reshape(len(cells), -1, 1) * self._tables.shape
        heat = parts * temperature.reshape(len(cells), -1, 1)
        self.temperatures = np.zeros(len(self._rises))
        capacity, content = (
            np.bincount(cells.ravel(), weights=values.sum(axis=1).ravel(), minlength=len(self._rises))
            for values in (parts, heat)
        )
        np.divide(content, capacity, out=self.temperatures, where=capacity > 0.0)
        self._conduct(0.0, temperature)

    def advance(self, dt: float, time: float) -> float:
        """Conduct heat for dt [s] from a time [s], after the points have accepted the rest of the step.

        Returns the heat that has come in [J].
        """
        points, round_ = self._points, self._round
        self._conduct(dt, points.new.temperature)
        self._threads.run(
            warm_nodes, len(self._supplied), round_.start, round_.entries, self._corners.reshape(-1, COLUMNS),
            self._sources(time + 0.5 * dt), self._held, self._given(time + dt), dt, self.temperatures, self._rises,
            self._supplied,
        )  # fmt: skip
        self._warm_points()
        return float(self._supplied.sum())

    def _warm_points(self) -> None:
        self._threads.run(
            warm_points, len(self._rates), self._element, self._tables, self._rises, self._residues,
            self._points.old.temperature,
        )  # fmt: skip

    def _conduct(self, dt: float, before: np.ndarray) -> None:
        """Fill what the elements give to the nodes; `before` : temperatures of the points before the step."""
        points = self._points
        self._threads.run(
            conduct, len(self._rates), self._geometry, self._element, self._tables, self._metric,
            points.old_deformation_gradient, self._body.scales, points.material.thermal_conductivity,
            points.material.density, self._capacities.fill(before), before, points.old.temperature,
            self.temperatures, dt, self._corners, self._residues, self._rates,
        )  # fmt: skip
        self.limit = 1.0 / float(self._rates.max())

    def _sources(self, time: float) -> np.ndarray:
        """Heat flow (n,) [W] through the boundary into the nodes."""
        sources = np.zeros(len(self._rises))
        for load, shares in self._fluxes:
            sources += at_time(load.flux, time) * shares
        return sources

    def _given(self, time: float) -> np.ndarray:
        """Given temperatures (n,) [K]; where boundaries meet, their mean, which is what Fourier's series has there."""
        given = np.zeros(len(self._rises))
        for load, nodes in self._held_by:
            given[nodes] += held_temperature(load, time)
        return given / self._times_held

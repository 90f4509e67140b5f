"""Heat conduction over an increment of any length: backward Euler on the spaces of `fem.conduction`.

The points' own heating comes first; with T the temperatures of the nodes after it, C their lumped capacities and K the
conductances in the deformed body, what conduction adds within dt is

    (C / dt + K) dT = Q - K T,    K_ab = sum_q k w_q (Jbar / s) (Fbar^-T G_a) . (Fbar^-T G_b)

with heat Q through the boundary at the end of the increment, and dT given where temperatures are; Fbar = s F as a
locking cure makes it.
"""

import numpy as np

from core_models.equilibrium.linear_solvers import make_linear_solver
from core_models.equilibrium.pattern import Pattern
from core_models.geometry import Geometry
from core_models.loads import Load
from core_models.points import MaterialPoints
from fem.body import Body
from fem.conduction import Conduction
from fem.heat_flow import CAPACITY, GAIN, SHARE
from meshes.mesh import Mesh


class ImplicitConduction(Conduction):
    """The temperatures of the nodes, stepped implicitly; parameters as of `fem.conduction.Conduction`.

    linear_solver : as `core_models.equilibrium.linear_solvers.make_linear_solver` takes it.
    """

    def __init__(
        self, mesh: Mesh, geometry: Geometry, integration: str, body: Body, points: MaterialPoints,
        loads: tuple[Load, ...], linear_solver: str | None,
    ) -> None:  # fmt: skip
        super().__init__(mesh, geometry, integration, body, points, loads)
        cells = self._tables.nodes
        self._free = np.zeros(len(mesh.points), dtype=np.bool_)
        self._free[cells] = True
        self._free &= ~self._held
        diagonal = np.flatnonzero(self._free)[:, None]
        self._pattern = Pattern([cells, diagonal], self._free, points.threads)
        self._linear = make_linear_solver(linear_solver, self._pattern) if self._pattern.size else None

    def advance(self, dt: float, time: float) -> float:
        """Conduct heat for dt [s] from a time [s], after the points have accepted the rest of the step.

        Returns the heat that has come in [J].
        """
        after = self._points.old.temperature
        self._conduct(0.0, self._points.new.temperature)
        capacity = self._sum_round(CAPACITY)
        over = np.divide(1.0, capacity, out=np.zeros_like(capacity), where=capacity > 0.0)
        self.temperatures += self._sum_round(GAIN) * over
        # What nodes cannot tell apart evens out slowly in explicit steps; an increment is long: nodes take part.
        self._conduct(dt, after)
        evened = self._sum_round(SHARE) * over
        self.temperatures += evened
        rise = self._rise(dt, time + dt, capacity)
        self.temperatures += rise
        self._rises[:] = rise + evened
        self._warm_points()
        return float((capacity * rise).sum())

    def _sum_round(self, column: int) -> np.ndarray:
        """Sum (n,) over the corners of elements at each node."""
        weights = self._corners[..., column].ravel()
        return np.bincount(self._tables.nodes.ravel(), weights=weights, minlength=len(self._rises))

    def _rise(self, dt: float, end: float, capacity: np.ndarray) -> np.ndarray:
        """Rises (n,) [K] of the nodes by conduction."""
        rise = np.where(self._held, self._given(end) - self.temperatures, 0.0)
        if self._linear is not None:
            conductances = self._conductances()
            right = self._sources(end) - self._flow(conductances, self.temperatures + rise)
            inertia = (capacity / dt)[self._free].reshape(-1, 1, 1)
            values = self._pattern.assemble([conductances, inertia])
            rise[self._free] = self._linear.solve(values, right[self._free])
        return rise

    def _conductances(self) -> np.ndarray:
        """Blocks (m, a, a) of K [W/K]."""
        tables, points = self._tables, self._points
        gradients = points.old_deformation_gradient
        scales = 1.0 if self._body.scales is None else self._body.scales
        dimension = tables.gradients.shape[-1]
        inverse = np.linalg.inv(gradients)[:, :dimension, :dimension].reshape(
            *tables.weights.shape, dimension, -1
        )
        weights = points.material.thermal_conductivity * np.linalg.det(gradients) / scales
        slopes = np.einsum("mqaJ,mqJi->mqai", tables.gradients, inverse)
        weighted = slopes * (weights.reshape(tables.weights.shape) * tables.weights)[..., None, None]
        return np.einsum("mqai,mqbi->mab", weighted, slopes)

    def _flow(self, conductances: np.ndarray, temperatures: np.ndarray) -> np.ndarray:
        """K T (n,) [W]."""
        cells = self._tables.nodes
        flows = np.einsum("mab,mb->ma", conductances, temperatures[cells])
        return np.bincount(cells.ravel(), weights=flows.ravel(), minlength=len(temperatures))

"""A body of finite elements as a system of equations: forces out of balance and their derivatives."""

import numpy as np

from core_models.equilibrium.gradient_operator import gradient_operator
from core_models.equilibrium.newton import Balance
from core_models.equilibrium.pattern import dofs_of
from core_models.geometry import Geometry
from core_models.laws import elastic_moduli
from core_models.loads import Load, Pressure, at_time
from core_models.material import Material
from core_models.points import MaterialPoints
from core_models.threads import Threads
from fem.body import Body
from fem.deformation import ELEMENT_CHUNK
from fem.elements import Sized
from fem.external import ExternalForces
from fem.facets import BoundaryFacets
from fem.implicit.follower import pressure_stiffness
from fem.implicit.stiffness import make_scratch, stiffen
from fem.supports import Supports
from meshes.mesh import Mesh

UNLOADED = (
    1e-6  # strain below which a body's forces may be round-off: its residual is measured by this strain's
)
RAMP = 1e-3  # of an increment: time within which loads are taken to change evenly


class ElementSystem:
    """`core_models.equilibrium.newton.System` of a body with its supports and loads.

    fixed (n, d) : given components. tables : degrees of freedom of elements, then of the facets of each pressure.
    forces (n, d) : of the elements on the nodes, loads (n, d) or None : from outside [N], of the last balance.
    work : of the points in the step of the last balance.
    """

    def __init__(
        self, mesh: Mesh, geometry: Geometry, body: Body, cure, points: MaterialPoints, material: Material,
        supports: Supports, loads: tuple[Load, ...], threads: Threads,
    ) -> None:  # fmt: skip
        self._threads, self._body, self._points, self._cure = threads, body, points, cure
        self.fixed = supports.fixed
        self._external = ExternalForces(loads, mesh, geometry, body.nodal_mass)
        self._pressures = [
            (load, BoundaryFacets(mesh, load.boundary, geometry))
            for load in loads
            if isinstance(load, Pressure)
        ]
        self._operator = gradient_operator(geometry, mesh.dimension)
        nodes = [mesh.cells, *(facets.nodes for _load, facets in self._pressures)]
        self.tables = [dofs_of(each, mesh.dimension) for each in nodes]
        elements, dofs = self.tables[0].shape
        self._element = Sized(mesh.cells.shape[1], points.n // elements)
        self._scratch = [make_scratch(dofs) for _thread in range(threads.count)]
        self._matrices = np.zeros((elements, dofs, dofs))
        self._forces = np.zeros((elements, dofs))
        self._stresses = np.zeros((points.n, 3, 3))
        self._tangents = np.zeros((points.n, 9, 9))
        self._smallest = UNLOADED * _elastic_force(body, material, mesh.dimension) * dofs**0.5
        self.forces = np.zeros(mesh.points.shape)
        self.loads: np.ndarray | None = None
        self.work = None

    def balance(self, x: np.ndarray, time: float, dt: float) -> Balance:
        """Forces out of balance at x (n, d) [m] at the end of a step dt [s]; PointFailure if that cannot be."""
        self._x, self._time = x, time
        points, body = self._points, self._body
        body.deform(x, points)
        self.work = points.linearise(dt, self._stresses, self._tangents)
        self._threads.run_with(
            stiffen, -(-len(self._forces) // ELEMENT_CHUNK), self._scratch, self._element, self._cure,
            body.space.tables, self._operator, points.deformation_gradient, body.trial_scales, self._stresses,
            self._tangents, self._forces, self._matrices,
        )  # fmt: skip
        flat = np.bincount(self.tables[0].ravel(), weights=self._forces.ravel(), minlength=x.size)
        self.forces = flat.reshape(x.shape)
        self.loads = self._external.at(x, time)
        residual, square = -self.forces, float((self._forces**2).sum())
        if self.loads is not None:
            residual, square = residual - self.loads, square + float((self.loads**2).sum())
        return Balance(residual, max(square**0.5, self._smallest), self._flowing())

    def load_slope(self, x: np.ndarray, time: float, step: float) -> np.ndarray:
        """d loads / d time (n, d) [N/s] at x (n, d) [m], from the loads at `time` and a little later than that."""
        later = RAMP * step
        before, after = self._external.at(x, time), self._external.at(x, time + later)
        return np.zeros(x.shape) if before is None else (after - before) / later

    def stiffness(self) -> list[np.ndarray]:
        """d residual / d x where `balance` has been last: blocks for each of `tables` [N/m]."""
        pressed = (
            pressure_stiffness(facets, at_time(load.pressure, self._time), self._x)
            for load, facets in self._pressures
        )
        return [self._matrices, *pressed]

    def _flowing(self) -> np.ndarray:
        new, old = self._points.new.equivalent_plastic_strain, self._points.old.equivalent_plastic_strain
        return np.zeros(self._points.n, dtype=np.bool_) if new is None else new > old


def _elastic_force(body: Body, material: Material, dimension: int) -> float:
    """Norm over the elements of shear modulus times volume over size [N]: about their forces at a strain of 1."""
    tables = body.space.tables
    size = tables.areas.sum(axis=1) ** (1.0 / dimension)
    shear = elastic_moduli(material.elasticity)[1]
    return shear * float(np.linalg.norm(tables.weights.sum(axis=1) / size))

"""Explicit finite elements: axisymmetric quads with mean dilatation, lumped mass, central differences."""

import math

import numpy as np

from core_models.arguments import check_between, check_motion
from core_models.bulk_viscosity import BulkViscosity
from core_models.laws import elastic_moduli
from core_models.ledger import EnergyLedger
from core_models.material import Material
from core_models.points import MaterialPoints, PointFailure
from core_models.redo import VANISHING_STEP, redoing, step_within
from core_models.status import OK
from core_models.threads import Threads
from core_models.walls import PLANE, check_wall
from fem.mean_dilatation import ELEMENT_CHUNK, deform, resist
from fem.motion import CONTACT_WORK, IMPULSE, NODE_CHUNK, move
from fem.shape import outline
from fem.space import elements_round_nodes, lumped_mass, quad_tables
from meshes.axisymmetric import axisymmetric
from meshes.mesh import Mesh
from meshes.quarters import quarter_polygons


class ExplicitSolver:
    """Explicit dynamics of an axisymmetric body that meets a rigid wall at z = 0.

    Parameters
    ----------
    mesh : `meshes.mesh.Mesh`. material : `Material`.
    velocity : initial axial velocity [m/s], negative towards the wall. temperature : initial [K].
    wall : 'unilateral' or 'plane'. viscosity : BulkViscosity or None. threads : number of threads.
    safety : part of the estimated stable step that is taken, in (0, 1].

    `advance` makes one step: motion of the nodes -> kinematics -> points -> nodal forces.
    """

    method = "fem-explicit"

    def __init__(
        self,
        mesh: Mesh,
        material: Material,
        *,
        velocity: float,
        temperature: float | None = None,
        wall: str = "unilateral",
        viscosity: BulkViscosity | None = None,
        threads: int = 1,
        safety: float = 0.9,
    ) -> None:
        check_between("safety", safety, 0.0, 1.0)
        check_motion(velocity, temperature)
        mesh = axisymmetric(mesh)
        self.mesh, self.material, self.wall, self.safety = mesh, material, check_wall(wall), safety
        self.threads = Threads(threads)
        self.tables = quad_tables(mesh)
        count = len(mesh.points)
        self.nodal_mass, self._corner_mass = lumped_mass(self.tables, material.density, count)
        self._round = elements_round_nodes(self.tables.nodes, count)
        self._on_axis = mesh.points[:, 0] == 0.0
        self.positions = mesh.points.copy()
        self.velocities = np.zeros((count, 2))
        self.velocities[:, 1] = velocity
        self._held = np.zeros(count, dtype=np.bool_)
        self.points = MaterialPoints(
            material, self.tables.weights.ravel(), temperature, viscosity, self.threads
        )
        elements = len(self.tables.nodes)
        self._volume_ratio = np.ones(4 * elements)
        self._next = tuple(
            a.copy() for a in (self.positions, self.velocities, self._held, self._volume_ratio)
        )
        self._shear_modulus = elastic_moduli(material.elasticity)[1]
        self._corner_forces = np.zeros((elements, 4, 2))
        chunks = -(-elements // ELEMENT_CHUNK)
        self._failures = np.zeros((chunks, 2), dtype=np.int64)
        self._steps = np.zeros(chunks)
        self._node_sums = np.zeros((-(-count // NODE_CHUNK), 2))
        self.time, self.step_count, self.point_updates = 0.0, 0, 0
        self.mass = float(self.nodal_mass.sum())
        self.initial_momentum = self.momentum
        self.wall_impulse, self.wall_force = 0.0, 0.0
        self._ledger = EnergyLedger(0.0, 0.0)
        self._resist()
        self.time_step = self._stable_step()
        self._first_step, self._last_step = self.time_step, 0.0
        self._ledger.initial = self.kinetic_energy()

    def advance(self, limit: float = math.inf) -> None:
        """Make one step; a step that some point cannot take is redone smaller.

        limit : time not to go beyond [s], later than `time`; it is met exactly.
        Raises RunFailure naming step, time, point and law when that does not help.
        """
        dt = step_within(self.time_step, limit - self.time)
        taken = redoing(
            self._attempt,
            dt,
            VANISHING_STEP * self._first_step,
            lambda: self.points.place(self.step_count + 1, self.time, int(self.point_volumes().argmin())),
            lambda reason: self.points.failure(reason, self.step_count + 1, self.time),
        )
        self._resist()
        self.time = limit if taken == limit - self.time else self.time + taken
        self.step_count += 1
        self.point_updates += self.points.n
        self._last_step = taken
        self.time_step = self._stable_step()

    def _attempt(self, dt: float) -> None:
        """Move, deform and advance the points by dt; nothing of it lasts unless all of it works."""
        x1, v1, held1, j1 = self._next
        middle = 0.5 * (self._last_step + dt)
        self.threads.run(
            move, len(self._node_sums), self._round.start, self._round.entries, self._corner_forces, self.nodal_mass,
            self._on_axis, self.wall == PLANE, dt, middle, self.positions, self.velocities, self._held, x1, v1, held1,
            self._node_sums,
        )  # fmt: skip
        self.threads.run(
            deform, len(self._failures), self.tables, x1, self.points.deformation_gradient, j1,
            self.points.lengths, self._failures,
        )  # fmt: skip
        bad = np.flatnonzero(self._failures[:, 0] != OK)
        if bad.size:
            raise PointFailure(*(int(value) for value in self._failures[bad[0]]))
        work = self.points.advance(dt)
        self.points.accept()
        self._next = (self.positions, self.velocities, self._held, self._volume_ratio)
        self.positions, self.velocities, self._held, self._volume_ratio = x1, v1, held1, j1
        impulse, contact = self._node_sums.sum(axis=0)[[IMPULSE, CONTACT_WORK]]
        self.wall_impulse += float(impulse)
        self.wall_force = float(impulse) / middle
        ledger = self._ledger
        ledger.contact -= float(contact)
        ledger.plastic += work.plastic
        ledger.viscosity += work.viscous
        ledger.strain += work.stress - work.plastic

    def _resist(self) -> None:
        """Internal forces and stable steps at the present positions."""
        points = self.points
        self.threads.run(
            resist, len(self._steps), self.tables, self.positions, self._volume_ratio, points.old.stress,
            points.viscous_pressure, points.wave_speed, points.viscosity, self.material.density,
            self._shear_modulus, self._corner_mass, self._corner_forces, self._steps,
        )  # fmt: skip

    def _stable_step(self) -> float:
        return self.safety * float(self._steps.min())

    def nodal_forces(self) -> np.ndarray:
        """Internal forces on the nodes (n, 2) [N]."""
        nodes, forces = self.tables.nodes.ravel(), self._corner_forces.reshape(-1, 2)
        count = len(self.nodal_mass)
        return np.column_stack([np.bincount(nodes, weights=forces[:, k], minlength=count) for k in range(2)])

    def kinetic_energy(self) -> float:
        """Kinetic energy at `time` [J]: that of the half step before, and half a step's power of the forces."""
        half = 0.5 * float((self.nodal_mass * (self.velocities**2).sum(axis=1)).sum())
        return half + 0.5 * self._last_step * float((self.nodal_forces() * self.velocities).sum())

    @property
    def ledger(self) -> EnergyLedger:
        """Energies up to now; the kinetic one is worked out when somebody looks."""
        self._ledger.kinetic = self.kinetic_energy()
        return self._ledger

    @property
    def momentum(self) -> float:
        """Axial momentum [kg m/s], half a step before `time`."""
        return float((self.nodal_mass * self.velocities[:, 1]).sum())

    @property
    def in_contact(self) -> bool:
        """Whether the wall has pushed during the last step."""
        return self.wall_force != 0.0

    def point_positions(self) -> np.ndarray:
        """Positions of the points (n, 2) [m]."""
        corners = self.positions[self.tables.nodes]
        return np.einsum("qI,eIk->eqk", self.tables.shape, corners).reshape(-1, 2)

    def point_volumes(self) -> np.ndarray:
        """Current volumes of the points (n,) [m^3]."""
        return self.points.reference_volumes * self._volume_ratio

    def domains(self) -> np.ndarray:
        """Deformed quarter of the element round each point (n, 4, 2) [m]."""
        return quarter_polygons(self.positions[self.tables.nodes])

    def outline(self) -> dict[str, np.ndarray]:
        """Deformed boundary: 'foot' (axis to rim), 'side' (foot to rear), 'rear' (rim to axis), each (k, 2) [m]."""
        return outline(self.mesh.boundaries, self.positions)

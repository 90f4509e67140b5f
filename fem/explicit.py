"""Explicit finite elements: lumped mass and central differences in three geometries."""

import math
from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike

from core_models.arguments import check_between
from core_models.body_checks import check_body
from core_models.bulk_viscosity import BulkViscosity
from core_models.geometry import find_geometry
from core_models.initial_deformation import cannot_be, check_displacement, deform_slowly
from core_models.initial_motion import field_values, initial_velocities
from core_models.ledger import EnergyLedger
from core_models.load_checks import check_loads, damping_of, damping_rate
from core_models.loads import Load
from core_models.material import Material
from core_models.mirror_images import symmetry_planes
from core_models.plane_symmetry import check_plane
from core_models.points import MaterialPoints, PointFailure
from core_models.redo import VANISHING_STEP, redoing, step_within
from core_models.threads import Threads
from core_models.walls import Wall, as_wall, check_above
from fem.body import Body
from fem.checkpoint import RestartableSteps
from fem.conduction import Conduction
from fem.cures.choice import find_cure
from fem.cures.own_share import check_own_share
from fem.elements import FULL
from fem.external import ExternalForces
from fem.hourglass import DEFAULT
from fem.motion import CONTACT, DAMPING, EXTERNAL, FRICTION, IMPULSE, NODE_CHUNK, SUMS, move, wall_mode
from fem.readout import Readout
from fem.supports import Supports
from meshes.axisymmetric import axisymmetric
from meshes.mesh import Mesh, check_mesh
from meshes.single_body import refuse_several_bodies

SQUEEZED = (
    "check velocity and material, try another resolution or other elements (quad4 and hex8 with full integration bear "
    "most, quadratic ones more without a cure), or material points"
)


class ExplicitSolver(RestartableSteps, Readout):
    """Explicit dynamics of a body.

    Parameters
    ----------
    mesh : `meshes.mesh.Mesh` of any kind. material : `Material`.
    geometry : 'axisymmetric' (default in two dimensions), 'plane-strain' or 'spatial' (three).
    velocity : initial [m/s]: a number along the last axis, a vector (d,), or a function of positions (n, d).
    displacement : initial [m], a function of positions (n, d), or None; the body starts with the stress of it.
    temperature : initial [K], None for the material's. loads : of `core_models.loads`.
    wall : None, 'unilateral', 'plane' or a `Wall`. viscosity : BulkViscosity or None. threads : number of threads.
    conduction : whether heat is conducted (core_models.conduction), else the body is adiabatic.
    integration : 'full' or 'reduced' (one point in quad4 and hex8, two along each edge of quad8 and hex20).
    cure : against locking: None for the element's own, 'none', 'mean-dilatation', 'linear-dilatation' (quadratic
    quads and hexahedra), 'nodal-average' (tri3, tet4). own_share : of its own volume ratio that a point keeps under
    the cure, 0 to 1 (`fem.cures.own_share`: a tenth keeps the surface of a neck smooth). hourglass : coefficient of the
    hourglass control of one-point elements, in (0, 1]. safety : part of the estimated stable step that is taken, in
    (0, 1].

    `advance` makes one step: motion of the nodes -> kinematics -> points -> nodal forces.
    Raises SceneError, MeshError or UnsupportedError for what cannot be.
    """

    method = "fem-explicit"

    def __init__(
        self,
        mesh: Mesh,
        material: Material,
        *,
        geometry: str | None = None,
        velocity: float | ArrayLike | Callable = 0.0,
        displacement: Callable | None = None,
        temperature: float | None = None,
        loads: tuple[Load, ...] = (),
        wall: Wall | str | None = None,
        viscosity: BulkViscosity | None = None,
        threads: int = 1,
        conduction: bool = False,
        integration: str = FULL,
        cure: str | None = None,
        own_share: float = 0.0,
        hourglass: float = DEFAULT,
        safety: float = 0.9,
    ) -> None:
        check_mesh(mesh)
        refuse_several_bodies(mesh, "fem.ExplicitSolver")
        check_body(material, temperature, viscosity)
        check_between("safety", safety, 0.0, 1.0)
        check_between("hourglass", hourglass, 0.0, 1.0)
        self.geometry = find_geometry(geometry, mesh.dimension)
        check_plane(material, self.geometry)
        self.mesh = axisymmetric(mesh) if geometry in (None, "axisymmetric") and mesh.dimension == 2 else mesh
        self._agreement = check_loads(loads, self.mesh, self.geometry, conduction=conduction)
        self.material, self.wall, self.safety = material, as_wall(wall), safety
        check_above(self.wall, self.mesh.points, self.geometry)
        check_displacement(displacement, self.mesh, self.geometry, loads, self.wall)
        self.cure = find_cure(cure, mesh.kind, integration)
        self.threads = Threads(threads)
        share = check_own_share(own_share, self.cure)
        self._body = Body(
            self.mesh, material, self.geometry, integration, self.cure, share, hourglass, self.threads
        )
        self.mass = float(self._body.nodal_mass.sum())
        self._supports = Supports(loads, self.mesh, self.geometry)
        self._external = ExternalForces(loads, self.mesh, self.geometry, self._body.nodal_mass)
        self._mass_damping = damping_of(loads)
        self.velocities = initial_velocities(velocity, self.mesh.points)
        volumes = self._body.space.tables.weights.ravel()
        self.points = MaterialPoints(material, volumes, temperature, viscosity, self.threads, conduction)
        planes = symmetry_planes(loads, self.mesh, self.geometry)
        self.points.connect(self.reference_positions, self.geometry, planes)
        self.positions = self.mesh.points.copy()
        count = len(self.positions)
        self._held = np.zeros(count, dtype=np.bool_)
        self._next = tuple(a.copy() for a in (self.positions, self.velocities, self._held))
        self._node_sums = np.zeros((-(-count // NODE_CHUNK), SUMS))
        self.time, self.step_count, self.point_updates, self.node_updates = 0.0, 0, 0, 0
        self._last_step, self._middle = 0.0, 1.0
        self.initial_momentum = self.momentum
        self.wall_impulse, self.wall_force = 0.0, 0.0
        self._ledger = EnergyLedger(0.0, 0.0)
        if displacement is not None:
            points = self.mesh.points
            self._displace(points + field_values("displacement", displacement, points, "m"))
        self._conduction = None
        if conduction:
            self._conduction = Conduction(
                self.mesh, self.geometry, integration, self._body, self.points, tuple(loads)
            )
        self._resist()
        self._first_step = self.time_step
        self._ledger.initial = (
            self.kinetic_energy() + self._ledger.strain + self._ledger.plastic + self._ledger.hourglass
        )

    def _displace(self, positions: np.ndarray) -> None:
        """Bring the undeformed body to given positions (n, d) [m], slowly; SceneError if it cannot be there."""
        try:
            self._body.deform(positions, self.points)
        except PointFailure as reason:
            raise cannot_be(reason) from None
        self._ledger.strain, self._ledger.plastic = deform_slowly(self.points)
        self._body.accept()
        self.positions[:] = positions

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
            SQUEEZED,
        )
        self.time = limit if taken == limit - self.time else self.time + taken
        self.step_count += 1
        self.point_updates += self.points.n
        self.node_updates += len(self.positions)
        self._last_step = taken
        self._resist()

    def _attempt(self, dt: float) -> None:
        """Move, deform and advance the points by dt; nothing of it lasts unless all of it works."""
        body, supports = self._body, self._supports
        x1, v1, held1 = self._next
        middle = 0.5 * (self._last_step + dt)
        self._agreement.check(self.time + 0.5 * dt)
        supports.move_to(self.time + 0.5 * dt)
        self.threads.run(
            move, len(self._node_sums), self.geometry, body.round.start, body.round.entries, body.corner_forces,
            self._loads, body.nodal_mass, supports.fixed, supports.given, wall_mode(self.wall),
            self.wall.friction if self.wall else 0.0, self._damping, dt, middle, self.positions, self.velocities,
            self._held, x1, v1, held1, supports.reactions, self._node_sums,
        )  # fmt: skip
        body.deform(x1, self.points)
        work = self.points.advance(dt)
        self.points.accept()
        body.accept()
        if self._conduction is not None:
            self._ledger.heat += self._conduction.advance(dt, self.time)
        self._next = (self.positions, self.velocities, self._held)
        self.positions, self.velocities, self._held = x1, v1, held1
        self._middle = middle
        if self.step_count == 0:
            # Velocities start at t = 0, not half a step before: what the first stress does to them is half its work.
            started = body.nodal_forces() * (v1 - self._next[1])
            self._ledger.initial -= 0.25 * dt * float(started.sum())
            if supports.reactions is not None:
                # What stops or starts with a support at once loses energy: the support has worked on what came of it.
                lost = 0.5 * float((supports.reactions * (v1 - self._next[1])).sum())
                self._ledger.contact += lost
                self._ledger.external += lost
        sums = [float(value) for value in self._node_sums.sum(axis=0)]
        self.wall_impulse += sums[IMPULSE]
        self.wall_force = sums[IMPULSE] / middle
        ledger = self._ledger
        ledger.contact -= sums[CONTACT]
        ledger.friction -= sums[FRICTION]
        ledger.damping -= sums[DAMPING]
        ledger.external += sums[EXTERNAL]
        ledger.plastic += work.plastic
        ledger.viscosity += work.viscous
        ledger.strain += work.stress - work.plastic

    def _resist(self) -> None:
        """All forces and the stable step at the present positions."""
        limit = math.inf if self._conduction is None else self._conduction.limit
        step = self.safety * min(self._body.resist(self.positions, self.points), limit)
        if step < math.inf:  # debris of a body that erosion has deleted sets no limit: the last one holds
            self.time_step = step
        self._ledger.hourglass = self._body.hourglass_energy
        self._loads = self._external.at(self.positions, self.time)
        self._damping = damping_rate(self._mass_damping, self.time)

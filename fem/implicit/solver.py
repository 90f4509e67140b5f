"""Implicit quasi-static finite elements: equilibrium at the end of every increment by Newton's method."""

import math
from pathlib import Path as FilePath

import numpy as np

from core_models.arguments import check_between
from core_models.equilibrium.free_motion import free_motion
from core_models.equilibrium.increments import Increments
from core_models.equilibrium.linear_solvers import make_linear_solver
from core_models.equilibrium.log import CONVERGED, CUT, ConvergenceLog, Increment, Start
from core_models.equilibrium.newton import Attempt, Newton
from core_models.equilibrium.path import PathNewton
from core_models.equilibrium.pattern import Pattern
from core_models.equilibrium.stalled import Stalled
from core_models.errors import (
    LoadBeyondEquilibrium,
    NoEquilibrium,
    SceneError,
    SingularStiffness,
    UnsupportedError,
)
from core_models.geometry import find_geometry
from core_models.ledger import EnergyLedger
from core_models.load_checks import check_loads
from core_models.loads import Damping, Load
from core_models.material import Material
from core_models.plane_symmetry import check_plane
from core_models.points import MaterialPoints, PointFailure
from core_models.redo import step_within
from core_models.threads import Threads
from fem.body import Body
from fem.cures.choice import NODAL, cures_of, find_cure, make_cure
from fem.elements import FULL, is_one_point_brick
from fem.hourglass import DEFAULT
from fem.implicit.checkpoint import RestartableIncrements
from fem.implicit.conduction import ImplicitConduction
from fem.implicit.frequency import lowest_frequency
from fem.implicit.load_limit import ADVICE, growing_loads
from fem.implicit.path import Path, make_measure
from fem.implicit.route import PathRoute, Route, TimeRoute
from fem.implicit.spurious_modes import refuse_spurious_modes
from fem.implicit.system import ElementSystem
from fem.shape_readout import ShapeReadout
from fem.single_body import refuse_several_bodies
from fem.supports import Supports
from meshes.axisymmetric import axisymmetric
from meshes.mesh import Mesh

CHECKS = "check supports and loads, and the mesh where it is worst"


class ImplicitSolver(RestartableIncrements, ShapeReadout):
    """Quasi-static deformation of a body: forces balance at the end of every increment, inertia plays no part.

    Parameters
    ----------
    mesh, material, geometry, temperature, loads, threads, conduction, integration, cure : as `fem.ExplicitSolver` takes
    them, but for nodal averages and one-point quads and hexahedra, which have no tangent here, and Damping, which is
    dynamic. Heat is conducted after each increment, by backward Euler.
    increment : of time to take [s], > 0; it is cut on failure, and grows again on ease. smallest : below it the run
    gives up [s]; by default 1e-6 of the increment.
    tolerance : on the residual, relative to all forces on nodes, in [1e-12, 1e-3]. iterations : allowed per increment.
    linear_solver : 'scipy', 'pardiso', 'petsc', or None for PARDISO where it can be imported, else SciPy. log : file
    for the convergence log in JSON lines, or None; `log.records` and `log.text()` hold it in any case.
    path : None, `PathLength` or `BoundaryMotion`: forces then grow and fall as equilibrium asks for, the body moves on;
    `time` is that of the motion, and `load_time` that at which loads are taken.

    Time is that of the histories of supports and loads, and of rate-dependent laws. A body force at current positions
    has no stiffness of its own, so that it costs iterations.
    `advance` makes one increment. Raises SceneError, MeshError or UnsupportedError for what cannot be.
    """

    method = "fem-implicit"

    def __init__(
        self,
        mesh: Mesh,
        material: Material,
        *,
        increment: float,
        geometry: str | None = None,
        temperature: float | None = None,
        loads: tuple[Load, ...] = (),
        threads: int = 1,
        integration: str = FULL,
        cure: str | None = None,
        smallest: float | None = None,
        tolerance: float = 1e-8,
        iterations: int = 20,
        linear_solver: str | None = None,
        log: FilePath | str | None = None,
        path: Path | None = None,
        conduction: bool = False,
    ) -> None:
        check_between("tolerance", tolerance, 1e-12, 1e-3)
        if temperature is not None:
            check_between("temperature", temperature, 0.0, math.inf, "K")
        self.geometry = find_geometry(geometry, mesh.dimension)
        check_plane(material, self.geometry)
        self.mesh = axisymmetric(mesh) if geometry in (None, "axisymmetric") and mesh.dimension == 2 else mesh
        refuse_several_bodies(self.mesh)
        check_loads(loads, self.mesh, self.geometry, conduction=conduction)
        if any(isinstance(load, Damping) for load in loads):
            raise SceneError("Damping does nothing without motion: take it off, or use fem.ExplicitSolver")
        self.material = material
        self.cure = find_cure(cure, mesh.kind, integration)
        _refuse_without_tangent(mesh.kind, integration, self.cure)
        refuse_spurious_modes(self.mesh, self.geometry, material, self.cure)
        self.threads = Threads(threads)
        self._body = Body(self.mesh, material, self.geometry, integration, self.cure, DEFAULT, self.threads)
        self.mass = float(self._body.nodal_mass.sum())
        volumes = self._body.space.tables.weights.ravel()
        self.points = MaterialPoints(material, volumes, temperature, None, self.threads, conduction)
        self.points.connect(self.reference_positions)
        self.positions = self.mesh.points.copy()
        self._supports = Supports(loads, self.mesh, self.geometry)
        projection = make_cure(self.cure, self.mesh, self._body.space)
        self._loads = tuple(loads)
        self._system = ElementSystem(
            self.mesh, self.geometry, self._body, projection, self.points, material, self._supports,
            self._loads, self.threads,
        )  # fmt: skip
        self._pattern = Pattern(self._system.tables, ~self._system.fixed.ravel(), self.threads)
        linear = make_linear_solver(linear_solver, self._pattern)
        self.log = ConvergenceLog(log)
        self.log.add(Start(self.method, self._pattern.size, len(self._pattern.columns), linear.name))
        newton = (self._system, self._pattern, linear, self.log, tolerance, iterations)
        if path is None:
            self._route: Route = TimeRoute(Newton(*newton), self._supports)
        else:
            measure = make_measure(path, self.mesh, self._supports)
            self._route = PathRoute(PathNewton(measure, *newton))
        self._increments = Increments(increment, smallest)
        self._conduction = None
        if conduction:
            self._conduction = ImplicitConduction(
                self.mesh, self.geometry, integration, self._body, self.points, self._loads, linear_solver
            )
        self._forces, self._velocity = np.zeros_like(self.positions), np.zeros_like(self.positions)
        self.time, self.step_count, self.point_updates = 0.0, 0, 0
        self._ledger = EnergyLedger(0.0, 0.0)

    @property
    def time_step(self) -> float:
        """The next increment to try [s]."""
        return self._increments.next

    @property
    def load_time(self) -> float:
        """Time at which loads are taken [s]: `time`, unless a path is followed."""
        return self._route.load_time

    @property
    def linear_solver(self) -> str:
        """Name of the linear solver."""
        return self.log.records[0].linear_solver

    @property
    def ledger(self) -> EnergyLedger:
        """Energies at `time`: external work by the trapezoidal rule, and what the stress did with it."""
        return self._ledger

    def kinetic_energy(self) -> float:
        """Nothing moves: 0 J."""
        return 0.0

    def nodal_forces(self) -> np.ndarray:
        """Internal forces on the nodes (n, d) [N]."""
        return self._forces

    def boundary_force(self, name: str) -> np.ndarray:
        """Force (d,) [N] of the supports of a boundary on the body; SceneError if it has none."""
        return self._supports.reaction(name)

    def lowest_frequency(self) -> float:
        """Lowest natural angular frequency at the present state [rad/s]; SingularStiffness for a body that is not held.

        Points are taken within 1 s to where they are, so that they unload elastically at most.
        """
        self._refuse_free_motion()
        system = self._system
        system.balance(self.positions, self.load_time, 1.0)
        free = ~system.fixed
        masses = np.broadcast_to(self.nodal_mass[:, None], free.shape)[free]
        return lowest_frequency(self._pattern, system.stiffness(), masses)

    def advance(self, limit: float = math.inf) -> None:
        """Make one increment; one without equilibrium is tried again smaller.

        limit : time not to go beyond [s], later than `time`; it is met exactly.
        Raises SingularStiffness naming the motion that no support holds, NoEquilibrium when the increment would become
        smaller than allowed; the last converged state is kept.
        """
        if self.step_count == 0:
            self._refuse_free_motion()
        number = 0
        dt = step_within(self.time_step, limit - self.time)
        while True:
            end = limit if dt == limit - self.time else self.time + dt
            attempt = Attempt(self.step_count + 1, number, end, dt)
            try:
                positions, corrections = self._route.attempt(self.positions, self._velocity, attempt)
                break
            except (Stalled, PointFailure) as reason:
                why = self._describe(reason)
                iterations = sum(
                    each.increment == attempt.increment and each.attempt == number
                    for each in self.log.iterations
                )
                self._end(attempt, iterations, CUT, why)
                dt = self._cut(attempt, why)
                number += 1
        self._accept(positions, dt, end)
        self.point_updates += self.points.n * (corrections + 1)
        self._end(attempt, corrections, CONVERGED)
        self._increments.converged(dt, corrections)

    def _cut(self, attempt: Attempt, why: str) -> float:
        """A smaller increment; NoEquilibrium with what to try where there is none."""
        place = f"increment {attempt.increment}, t = {attempt.time:.6e} s (material {self.material.name})"
        try:
            return self._increments.cut(attempt.step, f"{place}: {why}")
        except NoEquilibrium as reason:
            times = self.load_time, attempt.time
            growing = isinstance(self._route, TimeRoute) and growing_loads(
                self._loads, self.mesh, self.geometry, self.nodal_mass, self.positions, times
            )
            if not growing:
                raise NoEquilibrium(f"{reason}: {CHECKS}") from None
            raise LoadBeyondEquilibrium(
                f"{reason}. No equilibrium was found under more than {growing}: if that is all the body carries, "
                f"{ADVICE}; else {CHECKS}"
            ) from None

    def _accept(self, positions: np.ndarray, dt: float, end: float) -> None:
        system, ledger = self._system, self._ledger
        moved = positions - self.positions
        # In balance, what acts from outside is the opposite of what the elements do.
        ledger.external -= 0.5 * float(((self._forces + system.forces) * moved).sum())
        ledger.plastic += system.work.plastic
        ledger.strain += system.work.stress - system.work.plastic
        self._forces, self._velocity, self.positions = system.forces, moved / dt, positions
        if self._supports.reactions is not None:
            loads = 0.0 if system.loads is None else system.loads
            self._supports.reactions[:] = np.where(system.fixed, -system.forces - loads, 0.0)
        self.points.accept()
        self._body.accept()
        self._route.accept(dt)
        if self._conduction is not None:
            ledger.heat += self._conduction.advance(dt, self.time)
        self.time, self.step_count = end, self.step_count + 1

    def _refuse_free_motion(self) -> None:
        motion = free_motion(self.mesh.points, self._system.fixed, self.geometry)
        if motion:
            raise SingularStiffness(
                f"nothing holds the {motion}: the stiffness is singular; add Fixed, Prescribed or Symmetry"
            )

    def _describe(self, reason: Exception) -> str:
        if not isinstance(reason, PointFailure):
            return str(reason)
        per_element = self.points.n // len(self.mesh.cells)
        return f"{reason} at point {reason.point} (element {reason.point // per_element})"

    def _end(self, attempt: Attempt, iterations: int, outcome: str, reason: str = "") -> None:
        self.log.add(
            Increment(
                attempt.increment, attempt.number, iterations, attempt.time, attempt.step, outcome, reason
            )
        )


def _refuse_without_tangent(kind: str, integration: str, cure: str) -> None:
    if is_one_point_brick(kind, integration):
        raise UnsupportedError(
            f"one-point {kind} has no implicit hourglass control: use integration='full', which has a cure"
        )
    if cure == NODAL:
        quadratic = {"tri3": "tri6", "tet4": "tet10"}[kind]
        others = " or ".join(repr(each) for each in cures_of(kind, integration) if each != NODAL)
        raise UnsupportedError(
            f"the cure {NODAL!r} has no implicit tangent: use {quadratic} elements, or cure={others}"
        )

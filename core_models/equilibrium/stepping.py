"""Quasi-static increments of a solver, whatever its body is made of: attempts, cuts, ledger, refusals."""

import math
from pathlib import Path
from typing import Protocol

import numpy as np

from core_models.arguments import check_between
from core_models.equilibrium.free_motion import free_motion
from core_models.equilibrium.increments import Increments
from core_models.equilibrium.linear_solvers import make_linear_solver
from core_models.equilibrium.log import CONVERGED, CUT, ConvergenceLog, Increment, Start
from core_models.equilibrium.measures import Measure
from core_models.equilibrium.newton import Attempt, Newton, System
from core_models.equilibrium.path import PathNewton
from core_models.equilibrium.pattern import Pattern
from core_models.equilibrium.route import Held, PathRoute, Route, TimeRoute
from core_models.equilibrium.stalled import Stalled
from core_models.errors import LoadBeyondEquilibrium, NoEquilibrium, SceneError, SingularStiffness
from core_models.ledger import EnergyLedger
from core_models.loads import Damping, Load
from core_models.points import PointFailure, Work
from core_models.redo import step_within

CHECKS = "check supports and loads, and the mesh where it is worst"


class LoadedSystem(System, Protocol):
    """A system with what it was loaded with in the last balance.

    forces (n, d) : of the body on its nodes, loads (n, d) or None : from outside [N]. work : of the points.
    """

    forces: np.ndarray
    loads: np.ndarray | None
    work: Work


class QuasiStatic:
    """Equilibrium at the end of every increment: the part of a solver that `advance` needs.

    The solver has `method`, `geometry`, `material`, `threads` and `points`, calls `_start`, and says what its nodes are
    and where a point is. ADVICE : what to try where loads grow beyond what the body carries.
    """

    ADVICE = "prescribe displacements"

    def _start(
        self, nodes: np.ndarray, system: LoadedSystem, supports: Held, pattern: Pattern, *,
        increment: float, smallest: float | None, tolerance: float, iterations: int, linear_solver: str | None,
        log: Path | str | None, condition: float | None = None, measure: Measure | None = None,
    ) -> None:  # fmt: skip
        """Begin at time 0.

        nodes (n, d) : positions in the reference body [m]. condition : number of the stiffness at the start, for the
        log. measure : of the way along a path of equilibrium, None for loads that follow their histories in time.
        """
        check_between("tolerance", tolerance, 1e-12, 1e-3)
        check_between("iterations", iterations, 0, math.inf)
        self._nodes = nodes
        self._system, self._supports, self._pattern = system, supports, pattern
        linear = make_linear_solver(linear_solver, pattern)
        self.log = ConvergenceLog(log)
        self.log.add(Start(self.method, pattern.size, len(pattern.columns), linear.name, condition))
        newton = (system, pattern, linear, self.log, tolerance, iterations)
        self._route: Route = (
            TimeRoute(Newton(*newton), supports)
            if measure is None
            else PathRoute(PathNewton(measure, *newton))
        )
        self._increments = Increments(increment, smallest)
        self._places = nodes.copy()
        self._forces, self._velocity = np.zeros_like(nodes), np.zeros_like(nodes)
        self.time, self.step_count, self.point_updates, self.node_updates = 0.0, 0, 0, 0
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
                places, corrections = self._route.attempt(self._places, self._velocity, attempt)
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
        self._accept(places, dt, end)
        self.point_updates += self.points.n * (corrections + 1)
        self.node_updates += len(self._nodes) * (corrections + 1)
        self._end(attempt, corrections, CONVERGED)
        self._increments.converged(dt, corrections)

    def _cut(self, attempt: Attempt, why: str) -> float:
        """A smaller increment; NoEquilibrium with what to try where there is none."""
        place = f"increment {attempt.increment}, t = {attempt.time:.6e} s (material {self.material.name})"
        try:
            return self._increments.cut(attempt.step, f"{place}: {why}")
        except NoEquilibrium as reason:
            growing = isinstance(self._route, TimeRoute) and self._growing(self.load_time, attempt.time)
            if not growing:
                raise NoEquilibrium(f"{reason}: {CHECKS}") from None
            raise LoadBeyondEquilibrium(
                f"{reason}. No equilibrium was found under more than {growing}: if that is all the body carries, "
                f"{self.ADVICE}; else {CHECKS}"
            ) from None

    def _growing(self, before: float, after: float) -> str:
        """Loads that differ between two times [s], in words; '' if none does."""
        return ""

    def _accept(self, places: np.ndarray, dt: float, end: float) -> None:
        system, ledger = self._system, self._ledger
        moved = places - self._places
        # In balance, what acts from outside is the opposite of what the body does.
        ledger.external -= 0.5 * float(((self._forces + system.forces) * moved).sum())
        ledger.plastic += system.work.plastic
        ledger.strain += system.work.stress - system.work.plastic
        self._forces, self._velocity, self._places = system.forces, moved / dt, places
        if self._supports.reactions is not None:
            loads = 0.0 if system.loads is None else system.loads
            self._supports.reactions[:] = np.where(system.fixed, -system.forces - loads, 0.0)
        self.points.accept()
        self._route.accept(dt)
        self.time, self.step_count = end, self.step_count + 1

    def _free_motion(self) -> str:
        return free_motion(self._nodes, self._system.fixed, self.geometry)

    def _refuse_free_motion(self) -> None:
        motion = self._free_motion()
        if motion:
            raise SingularStiffness(
                f"nothing holds the {motion}: the stiffness is singular; add Fixed, Prescribed or Symmetry"
            )

    def _describe(self, reason: Exception) -> str:
        if not isinstance(reason, PointFailure):
            return str(reason)
        return f"{reason} at point {reason.point}{self._whereabouts(reason.point)}"

    def _whereabouts(self, point: int) -> str:
        """What else there is to say about where a point is."""
        return ""

    def _end(self, attempt: Attempt, iterations: int, outcome: str, reason: str = "") -> None:
        self.log.add(
            Increment(
                attempt.increment, attempt.number, iterations, attempt.time, attempt.step, outcome, reason
            )
        )


def refuse_damping(loads: tuple[Load, ...], explicit: str) -> None:
    """Refuse Damping, which is dynamic; SceneError. explicit : name of the solver that has it."""
    if any(isinstance(load, Damping) for load in loads):
        raise SceneError(f"Damping does nothing without motion: take it off, or use {explicit}")

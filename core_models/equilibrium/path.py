"""Newton's method along a path of equilibrium: the size of the loads is unknown too, and may fall.

With R(x, t) the forces out of balance under the loads of time t, and m the measure of the way gone in an increment,

    R(x, t) = 0,    m(x - x_0, t - t_0) = speed dt

are solved together: with x_R = - K^-1 R and x_t = - K^-1 dR/dt a correction is x_R + x_t c with
c = - (m - speed dt + m_u . x_R) / (m_u . x_t + m_s).
Source: Batoz and Dhatt, Int. J. Numer. Methods Eng. 14 (1979) 1262.
"""

from dataclasses import replace
from typing import Protocol

import numpy as np

from core_models.equilibrium.linear_solvers import LinearSolver
from core_models.equilibrium.log import ConvergenceLog
from core_models.equilibrium.measures import Measure
from core_models.equilibrium.newton import Attempt, Balance, Newton, System
from core_models.equilibrium.pattern import Pattern
from core_models.equilibrium.stalled import Stalled
from core_models.errors import SceneError

CLOSED = 1e-8  # of the way to go in an increment: what may be left


class LoadedSystem(System, Protocol):
    """A system whose loads change with time."""

    def load_slope(self, x: np.ndarray, time: float, step: float) -> np.ndarray:
        """d loads / d time (n, d) [N/s] at x (n, d) [m], from the loads at `time` and a little later than that."""


class PathNewton(Newton):
    """Newton's method on a system and on a measure of its way; parameters as of `Newton`."""

    def __init__(
        self, measure: Measure, system: LoadedSystem, pattern: Pattern, linear: LinearSolver, log: ConvergenceLog,
        tolerance: float, iterations: int,
    ) -> None:  # fmt: skip
        super().__init__(system, pattern, linear, log, tolerance, iterations)
        self._measure = measure

    def follow(
        self, start: np.ndarray, load: float, velocity: np.ndarray, load_rate: float, attempt: Attempt
    ) -> tuple[np.ndarray, float, int]:
        """Equilibrium a step further along the path.

        start (n, d) [m], load [s] : positions and load time before. velocity (n, d) [m/s], load_rate [-] : of the
        increment before, both 0 in the first, which goes along the tangent of growing loads.
        Returns positions (n, d), load time and how many corrections it took. Raises Stalled or PointFailure;
        SceneError if no load changes with time, or none in the direction that the measure is to grow.
        """
        measure, way = self._measure, self._measure.speed * attempt.step
        self._plastic = None
        if load_rate == 0.0:
            moved, rise = self._tangent(start, load, attempt)
        else:
            moved, rise = attempt.step * velocity, attempt.step * load_rate
        here = replace(attempt, time=load + rise)
        balance = self._balance(start + moved, here)
        self._record(balance, here, 0, 0.0, 1.0)
        for iteration in range(1, self._iterations + 1):
            short = measure.value(moved, rise) - way
            if self._is_settled(balance) and abs(short) <= CLOSED * abs(way):
                return start + moved, load + rise, iteration - 1
            residual, free = balance.residual, self._free
            to_balance, per_load = self._directions(balance, start + moved, load + rise, attempt.step)
            slopes, load_slope = measure.slopes(moved, rise)
            correction = _border(short, slopes, load_slope, to_balance, per_load)
            change = to_balance + correction * per_load
            moved, rise = moved + change, rise + correction
            here = replace(attempt, time=load + rise)
            balance = self._balance(start + moved, here)
            energy = abs(float((residual * change)[free].sum()))
            self._record(balance, here, iteration, energy, 1.0)
        if self._is_settled(balance):
            return start + moved, load + rise, self._iterations
        raise self._unsettled(balance)

    def _tangent(self, start: np.ndarray, load: float, attempt: Attempt) -> tuple[np.ndarray, float]:
        """Displacements and rise of the load time of the first increment."""
        balance = self._balance(start, replace(attempt, time=load))
        _to_balance, per_load = self._directions(balance, start, load, attempt.step)
        if not per_load.any():
            raise SceneError(
                "no load changes with time, so that there is no path to follow: give a Traction, Pressure or "
                "BodyForce that grows with t, or leave out 'path'"
            )
        rise = self._measure.speed * attempt.step / self._measure.value(per_load, 1.0)
        if not 0.0 < rise < np.inf:
            raise SceneError(
                "growing loads do not move the boundary of 'path' in the direction of its speed: change the sign of "
                "the speed, or choose another boundary or component"
            )
        return rise * per_load, rise

    def _directions(
        self, balance: Balance, x: np.ndarray, load: float, step: float
    ) -> tuple[np.ndarray, np.ndarray]:
        """x_R [m] and x_t [m/s], both (n, d)."""
        values = self._finite(self._pattern.assemble(self._system.stiffness()))
        slope = self._system.load_slope(x, load, step)
        free = self._free
        right = np.column_stack([-balance.residual[free], slope[free]])
        found = self._linear.solve(values, right)
        if not np.isfinite(found).all():
            raise Stalled("the stiffness is singular")
        directions = np.zeros((2, *x.shape))
        directions[:, free] = found.T
        return directions[0], directions[1]


def _border(
    short: float, slopes: np.ndarray, load_slope: float, to_balance: np.ndarray, per_load: np.ndarray
) -> float:
    """The correction c of the load time [s]."""
    along = float((slopes * per_load).sum()) + load_slope
    correction = -(short + float((slopes * to_balance).sum())) / along if along != 0.0 else np.inf
    if not np.isfinite(correction):
        raise Stalled("the measure of the path does not change along it")
    return correction

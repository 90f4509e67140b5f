"""Newton's method for the balance of forces at the end of an increment, with a line search."""

import math
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from core_models.equilibrium.linear_solvers import LinearSolver
from core_models.equilibrium.log import ConvergenceLog, Iteration
from core_models.equilibrium.pattern import Pattern
from core_models.equilibrium.stalled import Stalled
from core_models.points import PointFailure

SEARCHES = 4  # trials of a correction's length
SLACK = 0.8  # of the work of the imbalance on the correction that may be left


@dataclass(frozen=True)
class Balance:
    """Forces out of balance at trial positions.

    residual : (n, d) forces of the body on its supports and loads, minus the loads [N]; zero where nothing is held.
    scale : Euclidean norm of all forces that elements and loads exert on nodes [N], > 0 also where there are none.
    plastic : (points,) which flow.
    """

    residual: np.ndarray
    scale: float
    plastic: np.ndarray


class System(Protocol):
    """What Newton's method needs of a discretised body."""

    fixed: np.ndarray
    tables: list[np.ndarray]

    def balance(self, x: np.ndarray, time: float, dt: float) -> Balance:
        """Forces out of balance at x (n, d) [m] at the end of a step dt [s]; PointFailure if that cannot be."""

    def stiffness(self) -> list[np.ndarray]:
        """d residual / d x where `balance` has been last: blocks (m, k, k) [N/m], one array for each of `tables`."""


@dataclass(frozen=True)
class Attempt:
    """Which attempt at which increment: for the log; time at its end, at which loads are taken, and size [s]."""

    increment: int
    number: int
    time: float
    step: float


class Newton:
    """Newton's method on a system.

    tolerance : of the residual, relative to all forces of elements on nodes [-]. iterations : allowed in an increment.
    """

    def __init__(
        self, system: System, pattern: Pattern, linear: LinearSolver, log: ConvergenceLog, tolerance: float,
        iterations: int,
    ) -> None:  # fmt: skip
        self._system, self._pattern, self._linear, self._log = system, pattern, linear, log
        self._tolerance, self._iterations = tolerance, iterations
        self._free = ~system.fixed
        self._plastic: np.ndarray | None = None

    def solve(self, x: np.ndarray, target: np.ndarray, attempt: Attempt) -> tuple[np.ndarray, int]:
        """Equilibrium with the fixed components at `target`, from the guess x, both (n, d) [m].

        Returns the positions (n, d) and how many corrections it took. Raises Stalled or PointFailure.
        """
        free = self._free
        self._plastic = None
        balance = self._balance(x, attempt)
        jump = np.where(free, 0.0, target - x)
        moves = np.abs(jump).max() > 0.0
        self._record(balance, attempt, 0, 0.0, 1.0)
        for iteration in range(1, self._iterations + 1):
            if not moves and self._is_settled(balance):
                return x, iteration - 1
            correction = self._correct(balance, jump if moves else None)
            energy = abs(float((balance.residual * correction)[free].sum()))
            x, balance, length = self._move(x, correction, balance, moves, attempt)
            self._record(balance, attempt, iteration, energy, length)
            if moves:
                x = np.where(free, x, target)
                moves = False
        if self._is_settled(balance):
            return x, self._iterations
        raise self._unsettled(balance)

    def _unsettled(self, balance: Balance) -> Stalled:
        return Stalled(
            f"no equilibrium after {self._iterations} iterations, "
            f"a part of {self._out_of_balance(balance):.1e} of the forces is out of balance"
        )

    def _finite(self, values: np.ndarray) -> np.ndarray:
        if not np.isfinite(values).all():
            raise Stalled("the tangent is not finite")
        return values

    def _correct(self, balance: Balance, jump: np.ndarray | None) -> np.ndarray:
        """The correction (n, d) [m] that Newton's method asks for; fixed components move by `jump`."""
        system, free = self._system, self._free
        blocks = system.stiffness()
        right = -balance.residual.ravel()
        correction = np.zeros(right.size)
        if jump is not None:
            correction = jump.ravel().copy()
            for table, block in zip(system.tables, blocks, strict=True):
                forces = np.einsum("mij,mj->mi", block, correction[table])
                right -= np.bincount(table.ravel(), weights=forces.ravel(), minlength=right.size)
        values = self._finite(self._pattern.assemble(blocks))
        free = free.ravel()
        correction[free] = self._linear.solve(values, right[free])
        if not np.isfinite(correction).all():
            raise Stalled("the stiffness is singular")
        return correction.reshape(balance.residual.shape)

    def _move(
        self, x: np.ndarray, correction: np.ndarray, balance: Balance, whole: bool, attempt: Attempt
    ) -> tuple[np.ndarray, Balance, float]:
        """Positions after the correction, or after the part of it that the line search takes; balance; that part.

        The work of the imbalance on the correction is to fall to SLACK of what it was; secants find where it vanishes.
        """
        free = self._free
        work = float((balance.residual * correction)[free].sum())
        length = 1.0
        for trial in range(SEARCHES + 1):
            moved = x + length * correction
            try:
                after = self._balance(moved, attempt)
            except PointFailure:
                if whole or trial == SEARCHES:
                    raise
                length *= 0.5
                continue
            left = float((after.residual * correction)[free].sum())
            falls = self._out_of_balance(after) < self._out_of_balance(balance)
            if whole or falls or abs(left) <= SLACK * abs(work) or trial == SEARCHES:
                break
            overshoots = left * work < 0.0
            length *= min(max(work / (work - left), 0.1), 0.5) if overshoots else 0.5
        return moved, after, length

    def _balance(self, x: np.ndarray, attempt: Attempt) -> Balance:
        balance = self._system.balance(x, attempt.time, attempt.step)
        if not (math.isfinite(balance.scale) and np.isfinite(balance.residual).all()):
            raise Stalled("the forces are not finite")
        return balance

    def _is_settled(self, balance: Balance) -> bool:
        return self._out_of_balance(balance) <= self._tolerance

    def _out_of_balance(self, balance: Balance) -> float:
        return float(np.linalg.norm(balance.residual[self._free])) / balance.scale

    def _record(
        self, balance: Balance, attempt: Attempt, iteration: int, energy: float, length: float
    ) -> None:
        residual = np.where(self._free, balance.residual, 0.0)
        worst = int(np.abs(residual).argmax())
        node, component = divmod(worst, residual.shape[1])
        same = self._plastic is not None and bool((self._plastic == balance.plastic).all())
        self._plastic = balance.plastic
        self._log.add(
            Iteration(
                attempt.increment,
                attempt.number,
                iteration,
                attempt.time,
                attempt.step,
                float(np.linalg.norm(residual)),
                self._out_of_balance(balance),
                energy,
                float(residual.flat[worst]),
                node,
                component,
                length,
                int(balance.plastic.sum()),
                same,
            )  # fmt: skip
        )

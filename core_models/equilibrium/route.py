"""How an increment is solved: at the time that it ends, or along the path of equilibrium."""

import math
from typing import Protocol

import numpy as np

from core_models.equilibrium.newton import Attempt, Newton
from core_models.equilibrium.path import PathNewton

# Gauss-Legendre on [0, 1]: the displacement that prescribed velocities add up to within an increment.
TIMES = (0.5 - math.sqrt(0.15), 0.5, 0.5 + math.sqrt(0.15))
SHARES = (5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0)


class Held(Protocol):
    """Supports of the nodes.

    fixed (n, d) : which components are given. given (n, d) : velocities of these [m/s]. reactions (n, d) : forces [N],
    None where nothing is held.
    """

    fixed: np.ndarray
    given: np.ndarray
    reactions: np.ndarray | None

    def move_to(self, time: float) -> None:
        """Take the velocities at a time [s]."""

    def reaction(self, boundary: str) -> np.ndarray:
        """Sum of the reactions (d,) of a boundary [N]."""


class Route(Protocol):
    """load_time : time at which loads are taken [s], load_rate : its rate in the last increment [-]."""

    load_time: float
    load_rate: float

    def attempt(self, x: np.ndarray, velocity: np.ndarray, attempt: Attempt) -> tuple[np.ndarray, int]:
        """Equilibrium after the increment: positions (n, d) [m], and how many corrections it took.

        x (n, d) [m] : positions before. velocity (n, d) [m/s] : of the increment before.
        """

    def accept(self, dt: float) -> None:
        """Take what the last attempt of dt [s] has found."""


class TimeRoute:
    """Loads and supports follow their histories in time."""

    def __init__(self, newton: Newton, supports: Held) -> None:
        self._newton, self._supports = newton, supports
        self.load_time, self.load_rate = 0.0, 1.0

    def attempt(self, x: np.ndarray, velocity: np.ndarray, attempt: Attempt) -> tuple[np.ndarray, int]:
        """See `Route`."""
        self._end = attempt.time
        target = x + self._prescribed(attempt.step)
        return self._newton.solve(x + attempt.step * velocity, target, attempt)

    def accept(self, dt: float) -> None:
        """See `Route`."""
        self.load_time = self._end

    def _prescribed(self, dt: float) -> np.ndarray:
        """Displacements (n, d) [m] of the supports within the next dt [s]; 0 for free components."""
        supports, total = self._supports, np.zeros_like(self._supports.given)
        for place, share in zip(TIMES, SHARES, strict=True):
            supports.move_to(self.load_time + place * dt)
            total += share * dt * supports.given
        return np.where(supports.fixed, total, 0.0)


class PathRoute:
    """Loads grow and fall as equilibrium asks for."""

    def __init__(self, newton: PathNewton) -> None:
        self._newton = newton
        self.load_time, self.load_rate = 0.0, 0.0

    def attempt(self, x: np.ndarray, velocity: np.ndarray, attempt: Attempt) -> tuple[np.ndarray, int]:
        """See `Route`."""
        found = self._newton.follow(x, self.load_time, velocity, self.load_rate, attempt)
        self._end = found[1]
        return found[0], found[2]

    def accept(self, dt: float) -> None:
        """See `Route`."""
        self.load_rate = (self._end - self.load_time) / dt
        self.load_time = self._end

"""Paths of equilibrium are followed through limit points: a shallow truss snaps through, by its closed form."""

import numpy as np
import pytest

from core_models.equilibrium.linear_solvers import SuperLU
from core_models.equilibrium.log import ConvergenceLog
from core_models.equilibrium.measures import MeanDisplacement, PathLength
from core_models.equilibrium.newton import Attempt, Balance
from core_models.equilibrium.path import PathNewton
from core_models.equilibrium.pattern import Pattern
from core_models.errors import SceneError
from core_models.threads import Threads

WIDTH, HEIGHT, STIFFNESS = 1.0, 0.25, 1e3
LENGTH = np.hypot(WIDTH, HEIGHT)


def resistance(height):
    """Downward force [N] on the apex of half a truss at a height [m]: EA (L - l) / L sin(angle)."""
    length = np.hypot(WIDTH, height)
    return STIFFNESS * (LENGTH - length) / LENGTH * height / length


class HalfTruss:
    """A bar from a pin at (WIDTH, 0) to an apex that slides along x = 0 under a dead load that is the time."""

    tables = [np.arange(4)[None, :]]
    fixed = np.array([[True, True], [True, False]])

    def balance(self, x, time, dt):
        """Forces of the bar, minus the load."""
        along = x[1] - x[0]
        self._length = np.hypot(*along)
        self._direction = along / self._length
        self._tension = STIFFNESS * (self._length - LENGTH) / LENGTH
        pull = self._tension * self._direction
        return Balance(np.array([-pull, pull + [0.0, time]]), STIFFNESS, np.zeros(1, dtype=bool))

    def stiffness(self):
        """Exact, of the bar."""
        across = np.outer(self._direction, self._direction)
        block = STIFFNESS / LENGTH * across + self._tension / self._length * (np.eye(2) - across)
        return [np.block([[block, -block], [-block, block]])[None]]

    def load_slope(self, x, time, step):
        """The load falls onto the apex at 1 N/s."""
        return np.array([[0.0, 0.0], [0.0, -1.0]])


def follow(measure, steps, system=None):
    """Heights and loads along the path."""
    system = system or HalfTruss()
    pattern = Pattern(system.tables, ~system.fixed.ravel(), Threads(1))
    newton = PathNewton(measure, system, pattern, SuperLU(pattern), ConvergenceLog(), 1e-10, 20)
    x, load = np.array([[WIDTH, 0.0], [0.0, HEIGHT]]), 0.0
    velocity, rate, rows = np.zeros_like(x), 0.0, []
    for step in range(steps):
        after, level, _corrections = newton.follow(x, load, velocity, rate, Attempt(step + 1, 0, 0.0, 1.0))
        velocity, rate, x, load = after - x, level - load, after, level
        rows.append((x[1, 1], load))
    return np.array(rows)


@pytest.mark.parametrize(
    "measure", [PathLength(0.01), PathLength(0.01, 0.01), MeanDisplacement(np.array([1]), 1, -0.015)]
)
def test_truss_snaps_through_along_its_closed_form(measure):
    """Past both limit points, with loads that fall, turn round and grow again, every state is on the curve."""
    heights, loads = follow(measure, 60).T
    assert loads == pytest.approx(resistance(heights), abs=1e-7)
    assert heights.min() < -1.2 * HEIGHT and (np.diff(heights) < 0.0).all()
    rises = np.sign(np.diff(loads))
    assert (np.diff(rises) != 0.0).sum() == 2 and rises[0] == rises[-1] == 1.0
    angle = np.arccos((WIDTH / LENGTH) ** (1.0 / 3.0))
    peak = STIFFNESS * (1.0 - (WIDTH / LENGTH) / np.cos(angle)) * np.sin(angle)
    assert loads[heights > 0.0].max() == pytest.approx(peak, rel=5e-3)


def test_steps_of_the_path_are_as_long_as_asked_for():
    """The measure of every increment is speed times step."""
    heights = follow(PathLength(0.01), 20)[:, 0]
    assert np.abs(np.diff(heights)) == pytest.approx(0.01 * 2.0**0.5, rel=1e-7)


def test_path_without_a_load_that_grows_is_refused():
    """Neither a load that stays nor a speed against the load leads anywhere."""
    system = HalfTruss()
    system.load_slope = lambda x, time, step: np.zeros_like(x)
    with pytest.raises(SceneError, match="no load changes with time"):
        follow(PathLength(0.01), 1, system)
    with pytest.raises(SceneError, match="change the sign of the speed"):
        follow(MeanDisplacement(np.array([1]), 1, 0.015), 1)

"""Coulomb friction on the wall: blocks that slide and blocks that stick, against the closed forms."""

import numpy as np
import pytest

from core_models.loads import Damping, gravity
from core_models.walls import Wall
from tests.mpm.conftest import CELL

G, FRICTION = 1e7, 0.3  # m/s^2; so large that a short run is long against the time of waves through the block
GEOMETRIES = ["plane-strain", "spatial"]


@pytest.fixture
def block_on_wall(body):
    """A block that stands on the wall, pressed down by its weight; `pull` : part of the friction it is pulled with."""

    def make(geometry="plane-strain", friction=FRICTION, pull=0.0, **options):
        d = 3 if geometry == "spatial" else 2
        down = np.zeros(d)
        down[-1], down[0] = -G, pull * FRICTION * G
        loads = (gravity(down), *options.pop("loads", ()))
        wall = Wall("unilateral", friction)
        return body(geometry, counts=(4, 4, 3)[:: -1 if d == 2 else 1][:d], wall=wall, loads=loads, **options)

    return make


@pytest.mark.parametrize("geometry", GEOMETRIES)
def test_a_sliding_block_slows_down_by_friction_times_gravity(block_on_wall, geometry):
    """v = v0 - mu g t; the tangential impulse is friction times the wall's to round-off while all slides one way.

    In space the foot also spreads, and rubs a little to the sides.
    """
    speed = np.zeros(3 if geometry == "spatial" else 2)
    speed[0] = 60.0
    solver = block_on_wall(geometry, velocity=speed)
    end = 0.5 * speed[0] / (FRICTION * G)
    while solver.time < end:
        solver.advance(end)
    lost = solver.initial_momentum[0] - solver.momentum[0]
    assert lost == pytest.approx(
        FRICTION * solver.wall_impulse, rel=1e-9 if geometry == "plane-strain" else 1e-4
    )
    assert solver.momentum[0] / solver.mass == pytest.approx(speed[0] - FRICTION * G * end, rel=0.05)
    moved = (solver.positions - solver.reference_positions)[:, 0].mean()
    assert moved == pytest.approx(speed[0] * end - 0.5 * FRICTION * G * end**2, rel=0.03)
    assert solver.ledger.friction == pytest.approx(FRICTION * solver.mass * G * moved, rel=0.05)
    assert abs(solver.ledger.relative_error) < 0.02


def test_friction_is_the_same_in_every_direction_along_the_wall(block_on_wall):
    """A block that slides askew is slowed along its way and not turned off it."""
    solver = block_on_wall("spatial", velocity=(40.0, 30.0, 0.0))
    while solver.time < 5e-6:
        solver.advance()
    lost = solver.initial_momentum[:2] - solver.momentum[:2]
    assert lost[0] * 3.0 == pytest.approx(lost[1] * 4.0, rel=1e-3)
    assert np.hypot(*lost) == pytest.approx(FRICTION * solver.wall_impulse, rel=1e-3)


def test_a_block_that_is_pulled_too_little_sticks(block_on_wall):
    """Pulled with half of what friction can hold, it leans and stays; the wall holds it with just that force."""
    solver = block_on_wall(pull=0.5, loads=(Damping(4e6),))
    while solver.time < 4e-6:
        solver.advance()
    foot = solver.boundary_positions("bottom")[:, 0].mean() - solver.mesh.points[:, 0].mean()
    free = 0.25 * FRICTION * G * solver.time**2
    assert abs(foot) < 0.01 * free
    assert np.abs(solver.velocities[:, 0]).max() < 0.02 * 0.5 * FRICTION * G * solver.time


def test_a_block_that_is_pulled_too_much_slides_off(block_on_wall):
    """Pulled with twice of what friction can hold, it moves by (a - mu g) t^2 / 2."""
    solver = block_on_wall(pull=2.0)
    end = 8e-6
    while solver.time < end:
        solver.advance(end)
    moved = (solver.positions - solver.reference_positions)[:, 0].mean()
    assert moved == pytest.approx(0.5 * FRICTION * G * end**2, rel=0.05)


def test_without_friction_nothing_slows_a_block(block_on_wall):
    """A smooth wall leaves the momentum along it as it is."""
    solver = block_on_wall(friction=0.0, velocity=(60.0, 0.0))
    for _ in range(100):
        solver.advance()
    assert solver.wall_impulse > 0.0
    assert solver.momentum[0] == pytest.approx(solver.initial_momentum[0], rel=1e-12)
    assert solver.ledger.friction == 0.0


def test_friction_holds_the_foot_of_a_bar(build, bar, j2):
    """In a Taylor impact, the foot spreads less the rougher the wall, and energy closes with the work of friction."""
    radii = []
    for friction in (0.0, 0.1, 1.0):
        solver = build("mpm", bar(4, 16), j2, velocity=-227.0, wall=Wall("unilateral", friction))
        while solver.time < 15e-6:
            solver.advance()
        radii.append(solver.outline()["foot"][:, 0].max())
        assert abs(solver.ledger.relative_error) < 0.01
        assert (solver.ledger.friction > 0.0) == (friction > 0.0)
    assert radii[0] > 1.02 * radii[1] > 1.02 * radii[2]
    assert radii[0] - 4 * CELL > 1.2 * (radii[2] - 4 * CELL)

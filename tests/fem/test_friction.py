"""Coulomb friction on the wall: a block on a slope against the closed form."""

import numpy as np
import pytest

from core_models.loads import BodyForce
from core_models.walls import Wall
from fem import ExplicitSolver
from meshes.block import block

G, FRICTION = 9.81, 0.3
SLIDING = np.arctan(0.5)  # slope on which the block slides
STICKING = np.arctan(0.2)  # slope on which it does not
RAMP = 1e-2  # s in which the weight comes on, ten times the period of the block's own swing, so that it does not hop


def lasting(time):
    """Integral of the share of the weight that is on, up to a time later than RAMP [s]."""
    return time - 0.5 * RAMP


@pytest.fixture(
    params=[("plane-strain", "quad4"), ("spatial", "hex8"), ("spatial", "tet10")], ids=lambda p: p[1]
)
def on_slope(request, elastic):
    """Make a block of 1 m that lies on the wall, gravity tilted against it by a slope."""
    geometry, kind = request.param
    d = 3 if geometry == "spatial" else 2

    def make(slope, wall, speed=0.0):
        pull, velocity = np.zeros(d), np.zeros(d)
        pull[0], pull[-1] = G * np.sin(slope), -G * np.cos(slope)
        velocity[0] = speed
        weight = BodyForce(lambda x, t: min(t / RAMP, 1.0) * pull)
        mesh = block([0.0] * d, [1.0] * d, [2] * d, kind)
        return ExplicitSolver(mesh, elastic, geometry=geometry, wall=wall, loads=(weight,), velocity=velocity)

    return make


@pytest.mark.parametrize("kind", ["unilateral", "plane"])
def test_a_block_on_a_steep_slope_slides_with_the_closed_form(on_slope, kind):
    """Acceleration g (sin - mu cos), the wall carries the weight, friction takes its force times the way."""
    solver = on_slope(SLIDING, Wall(kind, FRICTION))
    while solver.time < 3e-2:
        solver.advance(3e-2)
    time = lasting(solver.time)
    acceleration = G * (np.sin(SLIDING) - FRICTION * np.cos(SLIDING))
    assert solver.momentum[0] == pytest.approx(solver.mass * acceleration * time, rel=5e-3)
    weight = solver.mass * G * np.cos(SLIDING)
    assert solver.wall_impulse == pytest.approx(weight * time, rel=5e-3)
    power = FRICTION * weight / (solver.mass * acceleration) * 0.5 * solver.mass * (acceleration * time) ** 2
    assert solver.ledger.friction == pytest.approx(power, rel=1e-2)
    assert abs(solver.ledger.relative_error) < 5e-3


def test_a_block_on_a_flat_slope_sticks(on_slope):
    """Below the angle of friction the block stays; only a corner that carries little may give a thousandth of it."""
    solver = on_slope(STICKING, Wall("plane", FRICTION))
    while solver.time < 2e-2:
        solver.advance()
    foot = solver.mesh.points[:, -1] == 0.0
    moved = solver.positions[foot, 0] - solver.mesh.points[foot, 0]
    free = 0.5 * G * np.sin(STICKING) * solver.time**2
    assert np.abs(moved).max() < 1e-3 * free
    assert abs(solver.momentum[0]) < 1e-2 * solver.mass * G * np.sin(STICKING) * solver.time


def test_without_friction_the_block_slides_freely(on_slope):
    """No friction: g sin along the slope, and no work of friction."""
    solver = on_slope(SLIDING, "plane")
    while solver.time < 2e-2:
        solver.advance(2e-2)
    assert solver.momentum[0] == pytest.approx(
        solver.mass * G * np.sin(SLIDING) * lasting(solver.time), rel=2e-3
    )
    assert solver.ledger.friction == 0.0


def test_a_sliding_block_is_stopped_in_the_closed_forms_time(on_slope):
    """On a level wall a block of 0.1 m/s stops after v / (mu g) of its full weight, and stays."""
    speed = 0.1
    solver = on_slope(0.0, Wall("unilateral", FRICTION), speed)
    stop = speed / (FRICTION * G) + 0.5 * RAMP
    while solver.time < 0.8 * stop:
        solver.advance(0.8 * stop)
    left = speed - FRICTION * G * lasting(solver.time)
    assert solver.momentum[0] == pytest.approx(left * solver.mass, rel=2e-2)
    while solver.time < 1.2 * stop:
        solver.advance()
    assert abs(solver.momentum[0]) < 0.01 * speed * solver.mass

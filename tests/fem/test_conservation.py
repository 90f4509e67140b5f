"""What a free body keeps, in every geometry."""

import numpy as np
import pytest

from core_models.errors import UnsupportedError
from core_models.walls import Wall

STIR = 100.0  # m/s

BODIES = [
    ("plane-strain", "quad4", "full", "mean-dilatation"),
    ("plane-strain", "tri3", "full", "nodal-average"),
    ("spatial", "hex8", "full", "mean-dilatation"),
    ("spatial", "hex8", "reduced", "none"),
    ("spatial", "tet4", "full", "nodal-average"),
    ("spatial", "tet10", "full", "mean-dilatation"),
]


@pytest.fixture(params=BODIES, ids=lambda which: "-".join(which))
def tumbling(request, element, j2):
    """A plastic body that tumbles and is torn at: velocities up to STIR at random, in small steps."""
    random = np.random.default_rng(5)
    return element(
        request.param, velocity=lambda x: random.uniform(-STIR, STIR, x.shape), material=j2, safety=0.2
    )


def test_a_free_body_keeps_mass_momentum_and_angular_momentum(tumbling):
    """All of them to round-off, while the body yields and its energy closes."""
    solver = tumbling
    momentum, scale = solver.momentum, solver.mass * STIR
    mass, turning = solver.mass, solver.angular_momentum
    for _ in range(100):
        solver.advance()
    assert solver.ledger.plastic > 0.05 * solver.ledger.initial
    assert np.abs(solver.momentum - momentum).max() < 1e-12 * scale
    assert np.abs(solver.angular_momentum - turning).max() < 1e-12 * scale
    assert solver.mass == mass
    assert abs(solver.ledger.relative_error) < 1e-2


def test_an_axisymmetric_body_has_no_angular_momentum(element):
    """It says so by a typed error."""
    solver = element(("axisymmetric", "quad4", "full", "none"))
    with pytest.raises(UnsupportedError, match="no angular momentum"):
        _ = solver.angular_momentum


@pytest.mark.parametrize("which", BODIES, ids=lambda which: "-".join(which))
@pytest.mark.parametrize("kind", ["unilateral", "plane"])
def test_the_walls_impulse_is_the_change_of_momentum(which, element, j2, kind):
    """A body falls on a wall with friction: normal momentum changes by the wall's impulse to round-off."""
    down = [30.0] * (2 if which[0] == "spatial" else 1) + [-200.0]
    solver = element(which, velocity=down, material=j2, wall=Wall(kind, 0.2), safety=0.5)
    for _ in range(100):
        solver.advance()
        change = solver.momentum[-1] - solver.initial_momentum[-1]
        assert change == pytest.approx(solver.wall_impulse, rel=1e-11)
    assert solver.ledger.friction > 0.0
    assert solver.ledger.contact > 0.0
    assert abs(solver.ledger.relative_error) < 2e-2


def test_a_spinning_body_keeps_its_stress_and_its_spin(element):
    """A spinning square: angular momentum to round-off, energy within 0.1 % over two turns."""
    spin = 300.0  # 1/s
    around = np.array([0.5, 0.5])
    solver = element(
        ("plane-strain", "quad4", "full", "mean-dilatation"),
        velocity=lambda x: spin * (x - around)[:, ::-1] * [-1.0, 1.0],
    )
    turning = solver.angular_momentum
    while solver.time < 4.0 * np.pi / spin:
        solver.advance()
    assert solver.angular_momentum == pytest.approx(turning, rel=1e-11)
    assert abs(solver.ledger.relative_error) < 1e-3
    assert solver.ledger.plastic == 0.0

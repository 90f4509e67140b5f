"""Modified update stress last: the particles' own new velocities deform them, and nothing is lost on the way."""

import numpy as np
import pytest

from core_models.bulk_viscosity import BulkViscosity
from core_models.errors import SceneError
from core_models.loads import Prescribed
from tests.mpm.conftest import CELL, stir


def test_a_linear_velocity_field_deforms_exactly(body):
    """The second mapping reproduces a linear field everywhere, at axis and symmetry plane too."""
    rates = np.array([300.0, -500.0])
    solver = body("axisymmetric", symmetries=["bottom"], update="musl", velocity=lambda x: rates * x)
    dt = solver.time_step
    solver.advance()
    gradient = np.diag(1.0 + dt * rates[[0, 1, 0]])
    assert np.abs(solver.points.fields()["deformation_gradient"].array - gradient).max() < 1e-13
    assert np.allclose(solver.velocities, rates * solver.reference_positions, rtol=1e-12, atol=1e-12)


def test_the_velocity_gradient_is_that_of_the_mapped_particles(body):
    """With random velocities F is not that of the grid's own velocity, and has less of what the grid smooths."""
    gradients = []
    for update in ("usl", "musl"):
        solver = body(update=update, transfer="pic")
        stir(solver)
        solver.advance()
        gradients.append(solver.points.old_deformation_gradient - np.eye(3))
    usl, musl = (float((change**2).sum()) for change in gradients)
    assert 0.05 * usl < musl < 0.8 * usl


@pytest.mark.parametrize("transfer", ["apic", "flip"])
def test_balances_close_in_an_impact(build, bar, j2, transfer):
    """The change of momentum is the wall's impulse to round-off; energy ends within 1 %."""
    options = {"update": "musl", "transfer": transfer, "viscosity": BulkViscosity(), "wall": "plane"}
    solver = build("mpm", bar(4, 16), j2, velocity=-227.0, **options)
    for _ in range(250):
        solver.advance()
        assert abs(solver.ledger.relative_error) < 2e-2
    assert abs(solver.ledger.relative_error) < 1e-2
    change = solver.momentum[-1] - solver.initial_momentum[-1]
    assert abs(change - solver.wall_impulse) < 1e-12 * abs(solver.initial_momentum[-1])
    assert solver.ledger.plastic > 0.5 * solver.ledger.initial
    assert np.abs(solver.boundary_positions("foot")[:, 1]).max() < 0.05 * CELL


def test_prescribed_motion_holds_in_the_second_mapping(body):
    """A strip between two planes, drawn at a constant rate from both ends, stretches evenly, ends included."""
    rate = 1e3
    ends = [Prescribed(name, 0, lambda x, t: rate * x[:, 0]) for name in ("left", "right")]
    planes = ["bottom", "top"]
    solver = body(update="musl", loads=ends, symmetries=planes, velocity=lambda x: rate * x * [1.0, 0.0])
    for _ in range(40):
        solver.advance()
    stretch = solver.points.old_deformation_gradient[:, 0, 0]
    assert np.abs(stretch - (1.0 + rate * solver.time)).max() < 1e-3 * rate * solver.time


def test_an_unknown_update_is_refused(body):
    """In one line, with the nearest name."""
    with pytest.raises(SceneError, match="musl"):
        body(update="musk")

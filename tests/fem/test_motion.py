"""Motion of a whole body: waves, walls, and what must be conserved."""

import numpy as np
import pytest

from core_models.bulk_viscosity import BulkViscosity
from meshes.taylor_bar import taylor_bar

CELL = 0.4e-3


@pytest.fixture
def rod(build, bar, elastic):
    """A slender elastic rod that meets the wall at 10 m/s; and the time a wave needs along it."""

    def make(wall):
        solver = build("fem-explicit", bar(2, 30), elastic, velocity=-10.0, wall=wall)
        bulk, shear = elastic.elasticity
        young = 9.0 * bulk * shear / (3.0 * bulk + shear)
        return solver, 30 * CELL / np.sqrt(young / elastic.density)

    return make


@pytest.fixture
def taylor(build, bar, j2):
    """A coarse Taylor bar with viscosity, step by step."""

    def steps(wall, count=400):
        solver = build(
            "fem-explicit", bar(4, 40), j2, velocity=-227.0, wall=wall, viscosity=BulkViscosity(0.06, 1.2)
        )
        for _ in range(count):
            solver.advance()
            yield solver

    return steps


def test_a_wave_runs_along_a_rod_with_the_bar_wave_speed(rod):
    """The rear turns round when the wave arrives, L / sqrt(E / rho) after the impact."""
    solver, travel = rod("plane")
    heights = []
    while solver.time < 1.5 * travel:
        solver.advance()
        heights.append((solver.outline()["rear"][:, 1].mean(), solver.time))
    assert min(heights)[1] == pytest.approx(travel, rel=0.03)


def test_an_elastic_rod_bounces_off_a_unilateral_wall(rod):
    """The rod leaves after two wave travels with its speed turned round, and the wall never pulls."""
    solver, travel = rod("unilateral")
    last_contact = 0.0
    while solver.time < 4.0 * travel:
        solver.advance()
        assert solver.wall_force >= 0.0
        last_contact = solver.time if solver.in_contact else last_contact
    assert last_contact == pytest.approx(2.0 * travel, rel=0.05)
    assert solver.momentum[-1] == pytest.approx(-solver.initial_momentum[-1], rel=0.1)
    assert solver.outline()["foot"][:, 1].min() > 0.0


def test_energy_of_an_elastic_rod_does_not_drift(rod):
    """Held by a plane wall without viscosity, the rod oscillates for 25 periods; the energy error does not grow."""
    solver, travel = rod("plane")
    errors = []
    while solver.time < 100.0 * travel:
        solver.advance()
        errors.append(abs(solver.ledger.relative_error))
    half = len(errors) // 2
    assert max(errors) < 1e-4
    assert max(errors[half:]) < 2.0 * max(errors[:half])


@pytest.mark.parametrize("wall", ["plane", "unilateral"])
def test_balances_close_in_a_taylor_impact(taylor, wall):
    """Mass is exact, the change of momentum is the wall's impulse to round-off, energy closes within 0.5 %."""
    masses = set()
    for solver in taylor(wall):
        masses.add(solver.mass)
        change = solver.momentum[-1] - solver.initial_momentum[-1]
        assert abs(change - solver.wall_impulse) < 1e-12 * abs(solver.initial_momentum[-1])
        assert abs(solver.ledger.relative_error) < 5e-3
    assert len(masses) == 1
    assert solver.ledger.plastic > 0.1 * solver.ledger.initial
    assert min(solver.ledger.viscosity, solver.ledger.contact) > 0.0
    assert solver.ledger.transfer == 0.0


def test_a_plane_wall_holds_what_has_touched_it(taylor):
    """Every node of the foot stays at z = 0 for good."""
    for solver in taylor("plane"):
        assert (solver.outline()["foot"][:, 1] == 0.0).all()


def test_a_unilateral_wall_lets_the_rim_lift_but_nothing_pass(taylor):
    """No node gets below z = 0, the wall never pulls, and the rim of the foot leaves it."""
    for solver in taylor("unilateral"):
        assert solver.positions[:, 1].min() >= 0.0
        assert solver.wall_force >= 0.0
    foot = solver.outline()["foot"][:, 1]
    assert foot[-1] > 0.01 * CELL
    assert foot[0] == 0.0


@pytest.mark.parametrize("wall", ["plane", "unilateral"])
def test_a_bar_that_starts_above_the_wall_touches_it_at_the_right_time(build, bar, j2, wall):
    """Free flight over 2.37 elements: nothing happens before, the wall pushes in the step of the contact."""
    solver = build("fem-explicit", bar(3, 6, gap=2.37), j2, velocity=-227.0, wall=wall)
    contact = 2.37 * CELL / 227.0
    while solver.time + solver.time_step < contact:
        solver.advance()
        assert solver.wall_impulse == 0.0
        assert not solver.in_contact
    assert solver.momentum[-1] == pytest.approx(solver.initial_momentum[-1], rel=1e-12)
    assert np.abs(solver.points.fields()["stress"].array).max() < 1e-6 * j2.flow.yield_stress
    solver.advance()
    assert solver.in_contact
    assert solver.wall_impulse > 0.0


def test_elements_do_not_lock_in_plastic_flow(build, j2):
    """The classic bar with only 5 elements across spreads to the radius of fine meshes within 2 %."""
    mesh = taylor_bar(3.2e-3, 32.4e-3, 5)
    solver = build("fem-explicit", mesh, j2, velocity=-227.0, wall="plane", viscosity=BulkViscosity(0.0, 1.2))
    while solver.time < 80e-6:
        solver.advance()
    outline = solver.outline()
    assert outline["foot"][-1, 0] == pytest.approx(7.2256e-3, rel=0.02)
    assert outline["rear"][:, 1].mean() == pytest.approx(21.42e-3, rel=0.01)

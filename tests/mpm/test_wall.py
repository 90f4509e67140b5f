"""The wall in the material point method: touched at the right moment, never pulling, and left again."""

import numpy as np
import pytest

from core_models.bulk_viscosity import BulkViscosity
from core_models.errors import SceneError
from mpm import Solver

CELL, SPEED = 0.4e-3, 227.0
WALLS = ["plane", "unilateral"]


@pytest.fixture
def taylor(build, bar, j2):
    """A coarse Taylor bar with viscosity, step by step."""

    def steps(wall, count=300, **options):
        viscosity = BulkViscosity(0.06, 1.2)
        solver = build("mpm", bar(4, 24), j2, velocity=-SPEED, wall=wall, viscosity=viscosity, **options)
        for _ in range(count):
            solver.advance()
            yield solver

    return steps


@pytest.fixture
def rod(build, bar, elastic):
    """A slender elastic rod that meets the wall at 10 m/s; and the time a wave needs along it."""

    def make(wall):
        solver = build("mpm", bar(2, 30), elastic, velocity=-10.0, wall=wall)
        bulk, shear = elastic.elasticity
        young = 9.0 * bulk * shear / (3.0 * bulk + shear)
        return solver, 30 * CELL / np.sqrt(young / elastic.density)

    return make


@pytest.mark.parametrize("wall", WALLS)
@pytest.mark.parametrize("gap", [2.37, 1.0, 0.61])
@pytest.mark.parametrize("seeding", ["gauss", "lattice"])
def test_the_wall_is_felt_when_the_surface_touches_it(build, bar, j2, wall, gap, seeding):
    """The first impulse comes within 0.1 cell of travel of the right moment; before it nothing happens."""
    mesh = bar(4, 8, gap=gap)
    solver = build("mpm", mesh, j2, velocity=-SPEED, wall=wall, seeding=seeding)
    while solver.wall_impulse == 0.0:
        assert solver.momentum[1] == pytest.approx(solver.initial_momentum[1], rel=1e-12)
        assert np.abs(solver.points.fields()["stress"].array).max() < 1e-6 * j2.flow.yield_stress
        assert not solver.in_contact
        before = solver.time
        solver.advance()
    assert SPEED * before < gap * CELL + 0.1 * CELL
    assert SPEED * solver.time > gap * CELL - 0.1 * CELL
    assert solver.in_contact


@pytest.mark.parametrize("wall", WALLS)
@pytest.mark.parametrize("transfer", ["apic", "flip"])
def test_balances_close_in_a_taylor_impact(taylor, wall, transfer):
    """Mass is exact, the change of momentum is the wall's impulse to round-off, energy ends within 1 %."""
    masses = set()
    for solver in taylor(wall, transfer=transfer):
        masses.add(solver.mass)
        change = (solver.momentum - solver.initial_momentum)[1]
        assert abs(change - solver.wall_impulse) < 1e-12 * abs(solver.initial_momentum[1])
        assert abs(solver.ledger.relative_error) < 2e-2
    assert abs(solver.ledger.relative_error) < 1e-2
    assert len(masses) == 1
    assert solver.ledger.plastic > 0.5 * solver.ledger.initial
    assert min(solver.ledger.viscosity, solver.ledger.contact, solver.ledger.transfer) > 0.0


def test_a_unilateral_wall_never_pulls(taylor):
    """Its force is a push or nothing, and the foot does not pass it."""
    for solver in taylor("unilateral"):
        assert solver.wall_force >= 0.0
        assert solver.outline()["foot"][:, 1].min() > -0.1 * CELL


def test_a_plane_wall_holds_what_has_touched_it(taylor):
    """The whole foot, rim included, stays on the wall while it spreads, and the wall pulls to keep it there."""
    pulled = False
    for solver in taylor("plane"):
        foot = solver.outline()["foot"]
        assert np.abs(foot[:, 1]).max() < 0.03 * CELL
        pulled = pulled or solver.wall_force < 0.0
    assert foot[-1, 0] > 1.5 * 4 * CELL
    assert pulled


def test_an_elastic_rod_bounces_off_a_unilateral_wall(rod):
    """The rod leaves after two wave travels and flies off with nothing left that holds it."""
    solver, travel = rod("unilateral")
    last_contact = 0.0
    while solver.time < 4.0 * travel:
        solver.advance()
        last_contact = solver.time if solver.in_contact else last_contact
    assert last_contact == pytest.approx(2.0 * travel, rel=0.1)
    assert solver.momentum[1] > -0.85 * solver.initial_momentum[1]
    assert solver.outline()["foot"][:, 1].min() > 0.0


def test_a_wave_runs_along_a_rod_with_the_bar_wave_speed(rod):
    """The rear turns round when the wave arrives, L / sqrt(E / rho) after the impact."""
    solver, travel = rod("plane")
    heights = []
    while solver.time < 1.5 * travel:
        solver.advance()
        heights.append((solver.outline()["rear"][:, 1].mean(), solver.time))
    assert min(heights)[1] == pytest.approx(travel, rel=0.05)


def test_energy_of_an_elastic_rod_never_grows(rod):
    """Held by a plane wall, the rod swings for ten periods; kinetic and strain energy together do not rise."""
    solver, travel = rod("plane")
    while solver.time < 40.0 * travel:
        solver.advance()
        assert solver.ledger.kinetic + solver.ledger.strain < 1.005 * solver.ledger.initial
        assert abs(solver.ledger.relative_error) < 1.5e-2


@pytest.mark.parametrize(("wall", "speed"), [("unilateral", 227.0), ("unilateral", 400.0), ("plane", 400.0)])
def test_nothing_passes_the_wall(build, bar, j2, wall, speed):
    """No particle gets behind the wall, also where a stretched face spans several columns of nodes."""
    solver = build("mpm", bar(6, 24), j2, wall=wall, velocity=-speed)
    lowest = 0.0
    while solver.time < 25e-6:
        solver.advance()
        lowest = min(lowest, solver.point_positions()[:, 1].min())
    assert lowest > -1e-6 * CELL


@pytest.mark.parametrize("method", ["fem", "mpm"])
def test_a_limit_is_met_exactly(build, bar, j2, method):
    """The last steps are cut so that the run ends at the very time asked for, none of them next to nothing."""
    solver = build(method, bar(4, 12), j2, velocity=-SPEED)
    limit, steps = 1.2345e-6, []
    while solver.time < limit:
        before = solver.time
        solver.advance(limit)
        steps.append(solver.time - before)
    assert solver.time == limit
    assert min(steps) > 0.4 * max(steps)


@pytest.mark.parametrize(
    ("name", "value"),
    [("cfl", 5.0), ("cfl", -1.0), ("flip_fraction", np.nan), ("velocity", np.nan), ("temperature", -5.0),
     ("cell_size", 0.0), ("cell_size", 1e-12)],
)  # fmt: skip
def test_senseless_numbers_are_refused_when_the_solver_is_built(bar, j2, name, value):
    """A number outside its range is a SceneError with the remedy, not a run that goes wrong later."""
    arguments = {"cell_size": CELL, "velocity": -100.0} | {name: value}
    with pytest.raises(SceneError, match="give"):
        Solver(bar(4, 8), j2, **arguments)


def test_the_wall_stops_particles_that_no_face_covers(build, bar, j2):
    """At strains above 5 the foot's faces leave holes: a particle below the wall is pushed all the same."""
    impulses = []
    for height in (0.1, -0.1):
        solver = build("mpm", bar(4, 8), j2, velocity=-SPEED, wall="unilateral")
        rim = _rim(solver)
        inner = np.setdiff1d(np.arange(solver.points.n), rim)
        solver.positions[rim, 1] += 20.0 * CELL
        solver.positions[inner[0]] = [0.5 * CELL, height * CELL]
        solver.advance()
        impulses.append(solver.wall_impulse)
    assert impulses[0] == 0.0 and impulses[1] > 0.0


def _rim(solver):
    """Particles in the outermost rows and column, which have faces."""
    r, z = solver.positions.T / CELL
    return np.flatnonzero((r > 3.5) | (z < z.min() + 0.1) | (z > z.max() - 0.1))

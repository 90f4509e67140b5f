"""The total configuration: the same motion as in the updated one, seen from the reference body."""

import numpy as np
import pytest

from core_models.bulk_viscosity import BulkViscosity
from core_models.errors import SceneError, UnsupportedError
from core_models.loads import Prescribed, Pressure, Traction, gravity
from core_models.walls import Wall
from tests.mpm.conftest import CELL, stir

ROUND_OFF = 1e-12


@pytest.fixture
def total(body):
    """Make a block in the total configuration."""

    def make(*arguments, **options):
        return body(*arguments, configuration="total", **options)

    return make


def run(solver, steps):
    """Make some steps; returns the solver."""
    for _ in range(steps):
        solver.advance()
    return solver


def momentum_scale(solver):
    """Momentum that particles with the same speeds in one direction would have."""
    return float(solver.particle_mass @ np.linalg.norm(solver.velocities, axis=1))


@pytest.mark.parametrize("geometry", ["axisymmetric", "plane-strain", "spatial"])
def test_uniform_stretch_is_exact_however_large(total, geometry):
    """A body drawn to three times its length at a uniform rate has one F and one stress, at axis and rim too."""
    d = 3 if geometry == "spatial" else 2
    rates, end = np.array([-2e4, 8e4, -3e4])[:d], 2e-5
    solver = total(geometry, velocity=lambda x: rates * x)
    while solver.time < end:
        solver.velocities[:], solver.affine[:] = rates * solver.reference_positions, np.diag(rates)
        solver.points.old.stress[:] = 0.0
        solver.advance(end)
    stretch = np.ones(3)
    stretch[:d] += end * rates
    stretch[2] = stretch[0] if geometry == "axisymmetric" else stretch[2]
    assert np.abs(solver.points.old_deformation_gradient - np.diag(stretch)).max() < 1e-11
    assert np.allclose(solver.positions, stretch[:d] * solver.reference_positions, rtol=1e-11)
    assert np.allclose(solver.point_volumes(), stretch.prod() * solver.points.reference_volumes, rtol=1e-11)
    stress = solver.points.old.stress
    assert np.abs(stress - stress[0]).max() < 1e-9 * np.abs(stress).max()


def test_a_large_rotation_leaves_no_stress(total):
    """Turned by half a turn about a corner, the body is at R X with F = R, and nothing pulls at it."""

    def turn(angle):
        return np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])

    solver, steps = total(), 60
    for step in range(steps):
        dt = solver.time_step
        rate = (turn(np.pi * (step + 1) / steps) - turn(np.pi * step / steps)) / dt
        solver.velocities[:], solver.affine[:] = solver.reference_positions @ rate.T, rate
        solver.advance()
    assert np.allclose(solver.points.old_deformation_gradient[:, :2, :2], turn(np.pi), atol=1e-12)
    assert np.allclose(solver.positions, -solver.reference_positions, atol=1e-15)
    assert np.abs(solver.points.old.stress).max() < 1e-11 * solver.material.elasticity.bulk_modulus
    assert solver.time_step == pytest.approx(dt, rel=1e-9)


@pytest.mark.parametrize("geometry", ["axisymmetric", "plane-strain", "spatial"])
def test_small_vibrations_are_those_of_the_updated_configuration(body, geometry):
    """Over a period and more, displacements agree to the order of the strains."""
    displacements = []
    for configuration in ("updated", "total"):
        solver = body(geometry, configuration=configuration, velocity=lambda x: 0.05 * np.sin(700.0 * x))
        for time in np.linspace(0.0, 3e-6, 31)[1:]:
            while solver.time < time:
                solver.advance(time)
        displacements.append(solver.positions - solver.reference_positions)
    updated, other = displacements
    assert np.abs(other - updated).max() < 1e-3 * np.abs(updated).max()


@pytest.mark.parametrize("transfer", ["apic", "flip"])
def test_momentum_is_conserved(total, transfer):
    """To round-off, whatever the velocities, while the body tears at itself."""
    solver = total(transfer=transfer)
    stir(solver, speed=100.0)
    momentum, scale = solver.momentum, momentum_scale(solver)
    for _ in range(20):
        solver.advance()
        assert np.abs(solver.momentum - momentum).max() < ROUND_OFF * scale


def spin(solver_of, turns):
    """Angular momentum lost by a free block that spins for so many turns [-], and its energy error."""
    rate, middle = 1e5, CELL * np.array([2.5, 3.0])
    field = rate * np.array([[0.0, -1.0], [1.0, 0.0]])
    solver = solver_of(velocity=lambda x: (x - middle) @ field.T)
    before = solver.angular_momentum
    while solver.time < turns * 2.0 * np.pi / rate:
        solver.advance()
    return abs(solver.angular_momentum / before - 1.0), abs(solver.ledger.relative_error)


def test_a_spinning_body_keeps_angular_momentum_and_energy(total):
    """Through more than a turn; the nodes have no place of their own, so the balance is that of smooth motions."""
    drift, error = spin(total, 1.2)
    assert drift < 1e-3
    assert error < 1e-3


def test_half_a_body_moves_like_the_whole(total):
    """A symmetry plane of the reference body stands for the other half, in large deformation too."""
    pull = Traction("top", (3e9, 1e10))
    down = Traction("bottom", (3e9, -1e10))
    whole = run(total(counts=(4, 8), corner=(0, -4), loads=(pull, down)), 120)
    half = run(total(counts=(4, 4), symmetries=["bottom"], loads=(pull,)), 120)
    upper = whole.reference_positions[:, 1] > 0.0
    assert np.abs(half.positions - half.reference_positions).max() > 0.05 * CELL
    assert np.allclose(whole.positions[upper], half.positions, rtol=1e-9)


@pytest.mark.parametrize("geometry", ["axisymmetric", "plane-strain", "spatial"])
def test_nodal_forces_do_the_power_of_the_stress(body, nodes, geometry):
    """Forces times velocities of the nodes are minus P : dF/dt of the particles, also at axis and planes."""
    solver = body(geometry, symmetries=["bottom"], configuration="total")
    stir(solver, speed=200.0)
    run(solver, 4)
    stress, dt = solver.points.old.stress[:, [0, 3, 5, 3, 1, 4, 5, 4, 2]].reshape(-1, 3, 3), solver.time_step
    before = solver.points.old_deformation_gradient.copy()
    volumes = solver.point_volumes()
    solver.advance()
    rates = (solver.points.old_deformation_gradient - before) / dt @ np.linalg.inv(before)
    powers = volumes * (stress * rates).sum(axis=(1, 2))
    at = nodes(solver)
    assert (at.force * at.after).sum() == pytest.approx(-powers.sum(), abs=1e-11 * np.abs(powers).sum())


def test_pressure_follows_the_turned_surface(total):
    """On a body turned by a right angle, pressure on its top pushes along the turned normal."""
    quarter = np.array([[0.0, -1.0], [1.0, 0.0]])
    solver = total(displacement=lambda x: x @ (quarter - np.eye(2)).T, loads=(Pressure("top", 5e6),))
    solver.points.old.stress[:] = 0.0
    dt, width = solver.time_step, np.ptp(solver.mesh.points[:, 0])
    solver.advance()
    assert np.allclose(solver.momentum, [0.5 * dt * 5e6 * width, 0.0], rtol=1e-9, atol=1e-15)


@pytest.mark.parametrize("update", ["usl", "musl"])
def test_prescribed_ends_draw_a_strip_evenly(total, update):
    """Between two planes and from both ends at a constant rate; the work done on the ends is in the balance."""
    rate = 1e4
    ends = [Prescribed(name, 0, lambda x, t: rate * x[:, 0]) for name in ("left", "right")]
    options = {"update": update, "symmetries": ["bottom", "top"], "velocity": lambda x: rate * x * [1.0, 0.0]}
    solver = run(total(loads=ends, **options), 200)
    stretch = solver.points.old_deformation_gradient[:, 0, 0]
    assert np.abs(stretch - (1.0 + rate * solver.time)).max() < 2e-3 * rate * solver.time
    assert abs(solver.ledger.relative_error) < 1e-2


@pytest.mark.parametrize("kind", ["plane", "unilateral"])
def test_a_taylor_bar_shortens_like_that_of_finite_elements(build, bar, j2, kind):
    """Length within 0.5 %, momentum changes by the impulse of the wall, energy closes to 0.2 %, foot on the wall."""
    lengths = []
    for method, options in (("fem", {}), ("mpm", {"configuration": "total"})):
        solver = build(method, bar(4, 32), j2, velocity=-227.0, wall=kind, **options)
        while solver.time < 20e-6:
            solver.advance()
        lengths.append(solver.boundary_positions("rear")[:, 1].mean())
    assert lengths[1] == pytest.approx(lengths[0], rel=5e-3)
    change = solver.momentum[-1] - solver.initial_momentum[-1]
    assert abs(change - solver.wall_impulse) < 1e-12 * abs(solver.initial_momentum[-1])
    assert abs(solver.ledger.relative_error) < 2e-3
    assert solver.boundary_positions("foot")[:, 1].min() > -0.01 * CELL


def test_a_bouncing_block_leaves_the_wall(total):
    """An elastic block comes off a unilateral wall; from then on its momentum stays."""
    solver = run(total(wall="unilateral", velocity=-50.0, viscosity=BulkViscosity()), 300)
    assert solver.momentum[-1] > 0.5 * abs(solver.initial_momentum[-1])
    assert not solver.in_contact
    assert solver.positions[:, -1].min() > 0.0
    assert abs(solver.ledger.relative_error) < 1e-2


@pytest.mark.parametrize("geometry", ["plane-strain", "spatial"])
def test_friction_slows_a_sliding_block(total, geometry):
    """v = v0 - mu g t, with the tangential impulse friction times the normal one."""
    g, friction = 1e7, 0.3
    d = 3 if geometry == "spatial" else 2
    down, speed = np.zeros(d), np.zeros(d)
    down[-1], speed[0] = -g, 60.0
    solver = total(
        geometry, counts=(4, 4, 3)[:: -1 if d == 2 else 1][:d], wall=Wall("unilateral", friction),
        loads=(gravity(down),), velocity=speed,
    )  # fmt: skip
    end = 0.5 * speed[0] / (friction * g)
    while solver.time < end:
        solver.advance(end)
    lost = solver.initial_momentum[0] - solver.momentum[0]
    assert lost == pytest.approx(friction * solver.wall_impulse, rel=1e-6 if d == 2 else 1e-3)
    assert solver.momentum[0] / solver.mass == pytest.approx(speed[0] - friction * g * end, rel=0.05)
    assert abs(solver.ledger.relative_error) < 0.02


def test_threads_do_not_change_a_bit(build, bar, j2):
    """One and two threads give the same positions, velocities and stresses."""
    found = []
    for threads in (1, 2):
        options = {"velocity": -227.0, "wall": "plane", "configuration": "total", "threads": threads}
        solver = run(build("mpm", bar(8, 24), j2, **options), 30)
        found.append((solver.positions, solver.velocities, solver.points.old.stress))
    assert all(np.array_equal(one, two) for one, two in zip(*found, strict=True))


def test_what_is_not_there_is_refused(body):
    """In one line: an unknown configuration, conduction, and domains that would follow the deformation."""
    with pytest.raises(SceneError, match="total"):
        body(configuration="totall")
    with pytest.raises(UnsupportedError, match="updated"):
        body(configuration="total", conduction=True)
    with pytest.raises(UnsupportedError, match="'cpdi'.*quadratic"):
        body(configuration="total", interpolation="cpdi")

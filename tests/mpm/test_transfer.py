"""Transfers between particles and grid: what they conserve and what they reproduce."""

import numpy as np
import pytest

from tests.mpm.conftest import CELL, stir

ROUND_OFF = 1e-12
TRANSFERS = {
    "apic": {"transfer": "apic"},
    "flip": {"transfer": "flip"},
    "pic": {"transfer": "pic"},
    "xpic": {"transfer": "xpic", "xpic_order": 3},
}
SHAPES = ["linear", "gimp", "quadratic", "cubic"]


@pytest.fixture(params=TRANSFERS)
def transfer(request):
    """Options of each transfer."""
    return TRANSFERS[request.param]


@pytest.fixture
def hovering(build, bar, elastic):
    """An axisymmetric bar of 6 x 8 cells, unstressed."""

    def make(**options):
        return build("mpm", bar(6, 8, gap=3.3), elastic, **options)

    return make


def momentum_scale(solver):
    """Momentum that particles with the same speeds in one direction would have."""
    return float(solver.particle_mass @ np.linalg.norm(solver.velocities, axis=1))


@pytest.mark.parametrize("gap", [0.0, 0.37])
def test_mass_on_the_grid_is_the_exact_mass(build, bar, elastic, nodes, gap):
    """The nodes' masses sum to the particles', also at the axis."""
    solver = build("mpm", bar(3, 5, gap=gap), elastic)
    solver.advance()
    assert nodes(solver).mass.sum() == pytest.approx(solver.mass, rel=1e-14)


@pytest.mark.parametrize("geometry", ["plane-strain", "spatial"])
def test_transfers_conserve_momentum(body, geometry, transfer):
    """Any velocities of the particles keep their momentum to round-off over several steps, stress or not."""
    solver = body(geometry, **transfer)
    stir(solver)
    momentum, scale = solver.momentum, momentum_scale(solver)
    for _ in range(5):
        solver.advance()
        assert np.abs(solver.momentum - momentum).max() < ROUND_OFF * scale
    assert np.abs(solver.points.fields()["stress"].array).max() > 0.0


@pytest.mark.parametrize("shape", ["quadratic", "cubic"])
def test_apic_conserves_angular_momentum(body, shape):
    """With B-splines, stress included, the angular momentum of particles and affine velocities stays."""
    solver = body(interpolation=shape)
    stir(solver)
    before, scale = solver.angular_momentum, momentum_scale(solver) * 6.0 * CELL
    for _ in range(3):
        solver.advance()
        assert abs(solver.angular_momentum - before) < ROUND_OFF * scale


def test_apic_conserves_angular_momentum_in_space(body):
    """All three components."""
    solver = body("spatial")
    stir(solver)
    before, scale = solver.angular_momentum, momentum_scale(solver) * 6.0 * CELL
    for _ in range(3):
        solver.advance()
    assert np.abs(solver.angular_momentum - before).max() < ROUND_OFF * scale


def test_momentum_along_the_axis_is_conserved(hovering):
    """In a body of revolution."""
    solver = hovering()
    stir(solver)
    momentum, scale = solver.momentum[1], momentum_scale(solver)
    for _ in range(10):
        solver.advance()
        assert abs(solver.momentum[1] - momentum) < ROUND_OFF * scale


CASES = [("axisymmetric", shape) for shape in SHAPES] + [
    ("plane-strain", "quadratic"),
    ("spatial", "quadratic"),
]


@pytest.mark.parametrize(("geometry", "shape"), CASES)
def test_a_linear_velocity_field_survives_apic_exactly(body, geometry, shape):
    """A velocity field that symmetry planes and axis mirror comes back as it was, affine part included; F is exact.

    The body lies in the corner of two (three) planes, so that every particle near them takes part.
    """
    d = 3 if geometry == "spatial" else 2
    symmetries = ["left", "bottom"] if d == 2 else ["left", "front", "bottom"]
    rates = np.array([300.0, -500.0, 200.0])[:d]
    if geometry == "axisymmetric":
        symmetries = ["bottom"]
    solver = body(geometry, symmetries=symmetries, interpolation=shape, velocity=lambda x: rates * x)
    start, dt = solver.reference_positions, solver.time_step
    solver.advance()
    assert np.allclose(solver.velocities, rates * start, rtol=ROUND_OFF, atol=1e-12)
    assert np.abs(solver.affine - np.diag(rates)).max() < 1e-9 * 500.0
    assert np.allclose(solver.positions, (1.0 + dt * rates) * start, rtol=1e-13)
    gradient = np.eye(3)
    gradient[:d, :d] += dt * np.diag(rates)
    gradient[2, 2] += dt * rates[0] if geometry == "axisymmetric" else 0.0
    assert np.abs(solver.points.fields()["deformation_gradient"].array - gradient).max() < 1e-13
    assert np.allclose(
        solver.point_volumes(), np.linalg.det(gradient) * solver.points.reference_volumes, rtol=1e-13
    )


def test_stress_of_a_uniform_deformation_is_uniform(hovering, elastic):
    """All particles, those at axis and surface too, have the same stress after a linear motion."""
    solver = hovering()
    rates = np.array([3e5, -5e5])
    solver.velocities[:], solver.affine[:] = rates * solver.positions, np.diag(rates)
    solver.advance()
    stress = solver.points.fields()["stress"].array
    assert np.abs(stress).max() > 1e-3 * elastic.elasticity.bulk_modulus
    assert np.abs(stress - stress[0]).max() < 1e-12 * elastic.elasticity.bulk_modulus


@pytest.mark.parametrize("geometry", ["axisymmetric", "plane-strain", "spatial"])
def test_nodal_forces_do_the_power_of_the_stress(body, nodes, geometry):
    """Forces times velocities of the nodes are minus stress times rate of the particles, also at axis and planes."""
    solver = body(geometry, symmetries=["bottom"])
    stir(solver)
    for _ in range(3):
        solver.advance()
    stress, volumes, dt = solver.points.old.stress.copy(), solver.point_volumes(), solver.time_step
    before = solver.points.old_deformation_gradient.copy()
    solver.advance()
    velocity_gradient = (solver.points.old_deformation_gradient @ np.linalg.inv(before) - np.eye(3)) / dt
    symmetric = 0.5 * (velocity_gradient + velocity_gradient.transpose(0, 2, 1))
    rates = symmetric[:, [0, 1, 2, 0, 1, 2], [0, 1, 2, 1, 2, 0]]
    powers = volumes[:, None] * stress * rates * [1.0, 1.0, 1.0, 2.0, 2.0, 2.0]
    at = nodes(solver)
    assert (at.force * at.after).sum() == pytest.approx(-powers.sum(), abs=1e-11 * np.abs(powers).sum())


def test_flip_without_pic_keeps_velocities_that_no_force_changes(hovering):
    """flip_fraction = 1: without stress every particle keeps its own velocity."""
    solver = hovering(transfer="flip", flip_fraction=1.0)
    stir(solver)
    before = solver.velocities.copy()
    solver.advance()
    assert np.allclose(solver.velocities, before, atol=1e-13)


def test_pic_takes_the_velocity_of_the_grid(hovering):
    """Particles get what APIC gives particles that have no affine velocity yet; they carry none themselves."""
    pic, apic = hovering(transfer="pic"), hovering()
    for solver in (pic, apic):
        stir(solver)
    apic.affine[:] = 0.0
    for solver in (pic, apic):
        solver.advance()
    assert np.allclose(pic.velocities, apic.velocities, atol=1e-13)
    assert pic.affine is None


def test_flip_fraction_blends_linearly(hovering):
    """Velocities with fraction a are a times those of FLIP plus 1 - a times those of PIC."""
    found = {}
    for fraction in (0.0, 0.75, 1.0):
        solver = hovering(transfer="flip", flip_fraction=fraction)
        stir(solver)
        solver.advance()
        found[fraction] = solver.velocities
    assert np.allclose(found[0.75], 0.75 * found[1.0] + 0.25 * found[0.0], atol=1e-13)


def test_xpic_of_order_one_is_pic(hovering):
    """Its filter is the smoothing of PIC."""
    found = {}
    for name, options in {"pic": {"transfer": "pic"}, "xpic": {"transfer": "xpic", "xpic_order": 1}}.items():
        solver = hovering(**options)
        stir(solver)
        solver.advance()
        found[name] = solver.velocities
    assert np.array_equal(found["pic"], found["xpic"])


def test_xpic_filters_less_the_higher_its_order(body):
    """What is left of random velocities grows with the order from PIC's towards FLIP's, which keeps all."""
    left = []
    for order in (1, 2, 4, 8):
        solver = body(transfer="xpic", xpic_order=order)
        stir(solver)
        solver.advance()
        left.append(float((solver.velocities**2).sum()))
    assert left == sorted(left)
    assert left[-1] > 2.0 * left[0]


def test_xpic_is_the_sum_of_smoothed_velocities(body):
    """Order 2: S (2 - S+ S) v plus the acceleration, with S+ S from two steps of PIC that take next to no time."""
    symmetries, short = ["left", "bottom"], 1e-12
    pic, xpic = (body(transfer=name, symmetries=symmetries) for name in ("pic", "xpic"))
    stir(pic)
    stir(xpic)
    pic.advance(short)
    once = pic.velocities.copy()
    pic.advance(2.0 * short)
    twice = pic.velocities.copy()
    xpic.advance(short)
    assert np.allclose(xpic.velocities, 2.0 * once - twice, atol=1e-5)
    assert np.abs(xpic.velocities - once).max() > 1.0


def test_a_flying_body_stays_as_it_is(hovering, transfer):
    """A rigid translation keeps velocities and leaves no stress."""
    solver = hovering(velocity=200.0, **transfer)
    start = solver.positions.copy()
    for _ in range(50):
        solver.advance()
    assert np.allclose(solver.velocities, [0.0, 200.0], rtol=1e-10, atol=1e-8)
    assert np.allclose(solver.positions, start + [0.0, 200.0 * solver.time], rtol=1e-10, atol=1e-14)
    stress = solver.points.fields()["stress"].array
    assert np.abs(stress).max() < 1e-10 * solver.material.elasticity.bulk_modulus


def test_rigid_spin_is_carried_exactly(body):
    """One step of a body that spins about its middle moves every particle by its own velocity, of which F knows."""
    rate, middle = 1e3, CELL * np.array([2.5, 3.0])
    turn = rate * np.array([[0.0, -1.0], [1.0, 0.0]])
    solver = body(velocity=lambda x: (x - middle) @ turn.T)
    start, dt = solver.positions.copy(), solver.time_step
    solver.advance()
    assert np.allclose(solver.positions, start + dt * (start - middle) @ turn.T, atol=1e-15)
    found = solver.points.fields()["deformation_gradient"].array[:, :2, :2]
    assert np.abs(found - np.eye(2) - dt * turn).max() < 1e-12

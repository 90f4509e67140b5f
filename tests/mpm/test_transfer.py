"""Transfers between particles and grid: what they conserve and what they reproduce."""

import numpy as np
import pytest

from mpm.grid import FORCE_R, FORCE_Z, MASS

CELL = 0.4e-3
ROUND_OFF = 1e-12


@pytest.fixture
def hovering(build, bar, elastic):
    """A bar of 6 x 8 cells, unstressed and well above the wall."""

    def make(**options):
        return build("mpm", bar(6, 8, gap=3.3), elastic, **options)

    return make


def stir(solver, seed=0, inner=0.0):
    """Random velocities of particles at r > inner; the others rest."""
    moving = solver.positions[:, :1] > inner
    solver.velocities[:] = moving * np.random.default_rng(seed).normal(
        scale=10.0, size=solver.velocities.shape
    )


def angular_momentum(solver):
    """In the (r, z) plane, with the part that the particles' affine velocity carries."""
    (r, z), (v_r, v_z) = solver.positions.T, solver.velocities.T
    spin = 0.25 * solver.cell_size**2 * (solver.affine[:, 1, 0] - solver.affine[:, 0, 1])
    return float(solver.particle_mass @ (r * v_z - z * v_r + spin))


@pytest.mark.parametrize("gap", [0.0, 0.37])
def test_mass_on_the_grid_is_the_exact_mass(build, bar, elastic, gap):
    """The nodes' masses sum to the particles', also at axis and wall."""
    solver = build("mpm", bar(3, 5, gap=gap), elastic)
    solver.advance()
    assert solver._grid.sums[:, :, MASS].sum() == pytest.approx(solver.mass, rel=1e-14)


@pytest.mark.parametrize("transfer", ["apic", "flip"])
def test_transfers_conserve_axial_momentum(hovering, transfer):
    """Any velocities of the particles keep their axial momentum to round-off over several steps."""
    solver = hovering(transfer=transfer)
    stir(solver)
    momentum, scale = solver.momentum[-1], float(solver.particle_mass @ np.abs(solver.velocities[:, 1]))
    for _ in range(10):
        solver.advance()
        assert abs(solver.momentum[-1] - momentum) < ROUND_OFF * scale
    assert solver.wall_impulse == 0.0


def test_apic_conserves_angular_momentum_away_from_the_axis(hovering):
    """Without stress a step keeps the angular momentum in the (r, z) plane, affine part included."""
    solver = hovering()
    stir(solver, inner=3.0 * CELL)
    before = angular_momentum(solver)
    scale = float(solver.particle_mass @ np.linalg.norm(solver.velocities, axis=1)) * 10.0 * CELL
    solver.advance()
    assert np.abs(solver.affine).max() > 0.0
    assert abs(angular_momentum(solver) - before) < ROUND_OFF * scale


def test_a_linear_velocity_field_survives_apic_exactly(hovering):
    """v_r = a r, v_z = b z comes back from the grid as it was, affine part included; F is uniform and exact."""
    solver = hovering()
    rates = np.array([300.0, -500.0])
    start = solver.positions.copy()
    solver.velocities[:], solver.affine[:] = rates * start, np.diag(rates)
    dt = solver.time_step
    solver.advance()
    assert np.allclose(solver.velocities, rates * start, rtol=ROUND_OFF, atol=1e-12)
    assert np.allclose(solver.affine, np.diag(rates), atol=1e-9 * 500.0)
    assert np.allclose(solver.positions, (1.0 + dt * rates) * start, rtol=1e-14)
    gradient = np.diag(1.0 + dt * rates[[0, 1, 0]])
    assert np.abs(solver.points.fields()["deformation_gradient"].array - gradient).max() < 1e-14
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


def test_nodal_forces_do_the_power_of_the_stress(hovering):
    """Forces times velocities of the nodes are minus stress times rate of the particles, also at the axis."""
    solver = hovering()
    stir(solver)
    for _ in range(3):
        solver.advance()
    stress, volumes, dt = solver.points.old.stress.copy(), solver.point_volumes(), solver.time_step
    before = solver.points.old_deformation_gradient.copy()
    solver.advance()
    velocity_gradient = (solver.points.old_deformation_gradient @ np.linalg.inv(before) - np.eye(3)) / dt
    rates = velocity_gradient[:, [0, 1, 2, 0, 1], [0, 1, 2, 1, 0]]
    powers = volumes[:, None] * stress[:, [0, 1, 2, 3, 3]] * rates
    nodal = (solver._grid.sums[:, :, FORCE_R : FORCE_Z + 1] * solver._grid.after).sum()
    assert nodal == pytest.approx(-powers.sum(), abs=1e-11 * np.abs(powers).sum())


def test_flip_without_pic_keeps_velocities_that_no_force_changes(hovering):
    """flip_fraction = 1: without stress every particle keeps its own velocity."""
    solver = hovering(transfer="flip", flip_fraction=1.0)
    stir(solver)
    before = solver.velocities.copy()
    solver.advance()
    assert np.allclose(solver.velocities, before, atol=1e-13)


def test_pic_takes_the_velocity_of_the_grid(hovering):
    """flip_fraction = 0: particles get what APIC gives particles that have no affine velocity yet."""
    pic, apic = hovering(transfer="flip", flip_fraction=0.0), hovering()
    for solver in (pic, apic):
        stir(solver)
        solver.advance()
    assert np.allclose(pic.velocities, apic.velocities, atol=1e-13)
    assert not pic.affine.any()


def test_flip_fraction_blends_linearly(hovering):
    """Velocities with fraction a are a times those of FLIP plus 1 - a times those of PIC."""
    found = {}
    for fraction in (0.0, 0.75, 1.0):
        solver = hovering(transfer="flip", flip_fraction=fraction)
        stir(solver)
        solver.advance()
        found[fraction] = solver.velocities
    assert np.allclose(found[0.75], 0.75 * found[1.0] + 0.25 * found[0.0], atol=1e-13)


@pytest.mark.parametrize("transfer", ["apic", "flip"])
def test_a_flying_body_stays_as_it_is(hovering, transfer):
    """A rigid translation keeps velocities and leaves no stress."""
    solver = hovering(transfer=transfer, velocity=200.0)
    start = solver.positions.copy()
    for _ in range(50):
        solver.advance()
    assert np.allclose(solver.velocities, [0.0, 200.0], rtol=1e-10, atol=1e-8)
    assert np.allclose(solver.positions, start + [0.0, 200.0 * solver.time], rtol=1e-10, atol=1e-14)
    stress = solver.points.fields()["stress"].array
    assert np.abs(stress).max() < 1e-10 * solver.material.elasticity.bulk_modulus

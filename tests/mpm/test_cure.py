"""Mean dilatation: exact for linear fields, conserving, and a cure of locking and of oscillating pressures."""

import numpy as np
import pytest

from core_models.bulk_viscosity import BulkViscosity
from core_models.errors import SceneError
from tests.mpm.conftest import stir

CURE = "mean-dilatation"
BODIES = [
    ("updated", "plane-strain"), ("updated", "axisymmetric"), ("updated", "spatial"),
    ("total", "axisymmetric"), ("total", "spatial"),
]  # fmt: skip


@pytest.fixture(params=BODIES, ids="-".join)
def cured(request, body):
    """A block with the cure, at symmetry plane and axis."""
    configuration, geometry = request.param
    return lambda **options: body(
        geometry, symmetries=["bottom"], configuration=configuration, cure=CURE, **options
    )


def test_uniform_deformation_stays_uniform_to_round_off(cured):
    """F after a linear motion is that motion's at every particle, next to planes, axis and surface too."""
    solver = cured()
    d, axial = solver.mesh.dimension, "axi" in type(solver.geometry).__name__.lower()
    rates = np.array([3e4, -5e4, 2e4])[:d]
    solver.velocities[:], solver.affine[:] = rates * solver.positions, np.diag(rates)
    dt = solver.time_step
    solver.advance()
    gradient = np.diag(1.0 + dt * np.append(rates, rates[0] if axial else 0.0)[:3])
    assert np.abs(solver.points.old_deformation_gradient - gradient).max() < 1e-14
    stress = solver.points.old.stress
    assert np.abs(stress - stress[0]).max() < 1e-12 * solver.material.elasticity.bulk_modulus


def test_forces_do_the_power_of_the_stress_that_the_points_have(cured, nodes):
    """Though both are projected, to the order of a step's length; momentum stays, and volume is but passed round."""
    solver = cured()
    stir(solver, speed=50.0)
    for _ in range(3):
        solver.advance()
    stress = solver.points.old.stress[:, [0, 3, 5, 3, 1, 4, 5, 4, 2]].reshape(-1, 3, 3).copy()
    before, volumes = solver.points.old_deformation_gradient.copy(), solver.point_volumes()
    dt = 1e-5 * solver.time_step
    solver.advance(solver.time + dt)
    rates = (solver.points.old_deformation_gradient - before) / dt @ np.linalg.inv(before)
    powers = volumes * (stress * rates).sum(axis=(1, 2))
    at = nodes(solver)
    assert (at.force * at.after).sum() == pytest.approx(-powers.sum(), abs=1e-5 * np.abs(powers).sum())
    cured_growth = (solver.point_volumes() - volumes).sum() / dt
    assert np.abs(solver.point_volumes() / volumes - 1.0).max() > 1e-9
    assert cured_growth == pytest.approx(flow_out(solver, at, volumes), rel=1e-3)


def flow_out(solver, at, volumes):
    """Rate at which the body's volume grows [m^3/s]: the power of a unit tension, from forces of unit stress."""
    solver.points.old.stress[:] = [1.0, 1.0, 1.0, 0.0, 0.0, 0.0]
    velocities = at.after.copy()
    solver._fill()
    return -(at.force * velocities).sum()


def test_half_a_body_moves_like_the_whole(body):
    """Means beyond a symmetry plane are those of the image."""
    whole = body(counts=(4, 8), corner=(0, -4), cure=CURE, velocity=lambda x: 30.0 * np.sin(900.0 * x))
    half = body(counts=(4, 4), symmetries=["bottom"], cure=CURE, velocity=lambda x: 30.0 * np.sin(900.0 * x))
    for solver in (whole, half):
        for _ in range(20):
            solver.advance()
    upper = whole.reference_positions[:, 1] > 0.0
    assert np.allclose(whole.positions[upper], half.positions, rtol=1e-10)
    assert np.allclose(whole.volume_ratio[upper], half.volume_ratio, rtol=1e-10)


def roughness(solver):
    """Differences of the particles' pressures from the means of their mesh cells, over the yield stress."""
    pressure = solver.points.old.stress[:, :3].mean(axis=1).reshape(len(solver.mesh.cells), -1)
    return float(np.sqrt(((pressure - pressure.mean(axis=1, keepdims=True)) ** 2).mean()) / 0.4e9)


@pytest.fixture
def impact(build, bar, j2):
    """Run a coarse Taylor bar for half its time; returns radius of the foot [m], roughness and energy error."""

    def make(method="mpm", **more):
        options = {"velocity": -227.0, "wall": "plane", "viscosity": BulkViscosity()} | more
        solver = build(method, bar(5, 30), j2, **options)
        while solver.time < 20e-6:
            solver.advance(20e-6)
        radius = solver.boundary_positions("foot")[:, 0].max()
        return radius, roughness(solver), abs(solver.ledger.relative_error)

    return make


def test_a_bar_of_linear_functions_no_longer_locks(impact):
    """Its foot spreads like that of cured finite elements, its pressures stop oscillating, and energy closes."""
    options = {"interpolation": "linear", "configuration": "total"}
    right, _, _ = impact("fem")
    locked, rough, _ = impact(**options)
    radius, smooth, error = impact(cure=CURE, **options)
    assert locked < 0.9 * right
    assert radius == pytest.approx(right, rel=0.03)
    assert smooth < 0.05 * rough
    assert error < 3e-3


@pytest.mark.parametrize(
    ("options", "part"),
    [({"configuration": "total"}, 0.3), ({"transfer": "flip"}, 0.75)],
    ids=["total", "updated"],
)
def test_pressures_of_quadratic_splines_oscillate_less(impact, options, part):
    """In the updated configuration too, where particles move through the cells that means are taken over."""
    before, rough, _ = impact(**options)
    radius, smooth, error = impact(cure=CURE, **options)
    assert smooth < part * rough
    assert radius == pytest.approx(before, rel=0.01)
    assert error < 5e-3


def test_threads_do_not_change_a_bit(build, bar, j2):
    """One and two threads give the same positions and stresses."""
    found = []
    for threads in (1, 2):
        solver = build("mpm", bar(8, 24), j2, velocity=-227.0, cure=CURE, threads=threads)
        for _ in range(20):
            solver.advance()
        found.append((solver.positions, solver.points.old.stress, solver.volume_ratio))
    assert all(np.array_equal(one, two) for one, two in zip(*found, strict=True))


def test_a_cure_that_is_off_is_not_there(body):
    """No array and no call; an unknown one is refused with the nearest name."""
    for off in (None, "none"):
        assert body(cure=off)._cure is None
    assert body(configuration="total")._background.configuration.stretch is None
    with pytest.raises(SceneError, match="'mean-dilatation'"):
        body(cure="mean-dilation")

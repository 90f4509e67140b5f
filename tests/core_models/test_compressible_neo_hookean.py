"""Compressible neo-Hookean elasticity: a stress that follows from the deformation gradient alone."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from core_models.at_rest import initial_wave_speed
from core_models.bulk_viscosity import BulkViscosity
from core_models.driver import drive
from core_models.elasticity.isotropic import IsotropicElastic
from core_models.errors import MaterialError, RunFailure
from core_models.material import Material
from core_models.paths import principal_stretches, simple_shear, uniaxial_strain
from core_models.points import MaterialPoints
from core_models.updates.compressible_neo_hookean import CompressibleNeoHookean

FULL = [[0, 3, 5], [3, 1, 4], [5, 4, 2]]
DENSITY = 1000.0
MODULI = {"nu = 0.3": (1000.0, 0.3), "nu = 0": (1e7, 0.0), "nu = -0.2": (1e4, -0.2)}


def solid(young, poisson):
    """A solid from Young's modulus [Pa] and Poisson's ratio."""
    elasticity = IsotropicElastic.from_young(young, poisson)
    return Material("rubber", DENSITY, CompressibleNeoHookean(), elasticity)


def lame(young, poisson):
    """Lame's constants lambda and mu [Pa]."""
    return young * poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson)), 0.5 * young / (1.0 + poisson)


def energy(f, young, poisson):
    """W = mu/2 (tr b - 3) - mu ln J + lambda/2 ln^2 J."""
    first, second = lame(young, poisson)
    logarithm = np.log(np.linalg.det(f))
    return 0.5 * second * (np.sum(f**2) - 3.0) - second * logarithm + 0.5 * first * logarithm**2


def some_deformations(count, size=0.3, seed=4):
    """Deformation gradients with large strain and rotation, det F > 0."""
    random = np.random.default_rng(seed)
    f = np.eye(3) + random.uniform(-size, size, (count, 3, 3))
    assert np.all(np.linalg.det(f) > 0.1)
    return Rotation.random(count, rng=random).as_matrix() @ f


def one_step(material, f):
    """What one step from the undeformed state to a deformation gradient gives."""
    return drive(material, np.array([np.eye(3), f]), 1e-3)


@pytest.fixture(params=MODULI.values(), ids=list(MODULI))
def moduli(request):
    """Young's modulus [Pa] and Poisson's ratio."""
    return request.param


def test_stress_is_the_closed_form(moduli):
    """sigma = [mu (b - 1) + lambda ln J 1] / J for large strains and rotations, to round-off, in a single step."""
    first, second = lame(*moduli)
    for f in some_deformations(10):
        j, b = np.linalg.det(f), f @ f.T
        expected = (second * (b - np.eye(3)) + first * np.log(j) * np.eye(3)) / j
        found = one_step(solid(*moduli), f).stress[1][FULL]
        assert found == pytest.approx(expected, rel=1e-13, abs=1e-13 * second)


def test_simple_shear_needs_normal_stress(moduli):
    """In simple shear sigma_12 = mu gamma and sigma_11 = mu gamma^2, the others are 0."""
    second = lame(*moduli)[1]
    gamma = np.linspace(0.0, 3.0, 7)
    stress = drive(solid(*moduli), simple_shear(gamma), 1e-3).stress / second
    assert stress[:, 3] == pytest.approx(gamma, abs=1e-14)
    assert stress[:, 0] == pytest.approx(gamma**2, abs=1e-14)
    assert np.all(np.abs(stress[:, [1, 2, 4, 5]]) < 1e-14)


def test_without_lateral_contraction_a_bar_pulls_its_axis_only():
    """With nu = 0 a stretch along x, P_11 = mu (F - 1/F), needs no stress across; lambda is 0 up to round-off."""
    stretch = np.linspace(1.0, 2.0, 5)
    history = drive(solid(1e7, 0.0), uniaxial_strain(stretch), 1e-3)
    assert history.stress[:, 0] == pytest.approx(5e6 * (stretch - 1.0 / stretch), rel=1e-14)
    assert np.all(np.abs(history.stress[:, 1:]) < 1e-8)


def test_bulk_and_shear_modulus_do_as_well(moduli):
    """A solid stated by K and G is the one stated by E and nu."""
    first, second = lame(*moduli)
    stated = Material(
        "rubber", DENSITY, CompressibleNeoHookean(), IsotropicElastic(first + second * 2 / 3, second)
    )
    f = some_deformations(1)[0]
    assert one_step(stated, f).stress == pytest.approx(one_step(solid(*moduli), f).stress, rel=1e-13)


def test_stress_is_the_slope_of_the_energy(moduli):
    """P = J sigma F^-T = dW/dF by central differences of the work that the points report."""
    material, h = solid(*moduli), 1e-5
    for f in some_deformations(2):
        piola = np.linalg.det(f) * one_step(material, f).stress[1][FULL] @ np.linalg.inv(f).T
        slopes = np.empty((3, 3))
        for place in np.ndindex(3, 3):
            step = np.zeros((3, 3))
            step[place] = h
            works = [one_step(material, f + sign * step).stress_work[1] for sign in (1.0, -1.0)]
            slopes[place] = (works[0] - works[1]) / (2.0 * h)
        assert slopes == pytest.approx(piola, rel=1e-7, abs=1e-7 * np.abs(piola).max())


def test_work_is_the_change_of_the_stored_energy(moduli):
    """After any path the work is W at its end, to round-off; a closed path gives all of it back."""
    path = np.concatenate([[np.eye(3)], some_deformations(20), [np.eye(3)]])
    history = drive(solid(*moduli), path, 1e-3)
    expected = [energy(f, *moduli) for f in path]
    assert history.stress_work == pytest.approx(expected, abs=1e-13 * max(expected))
    assert np.all(history.plastic == 0.0)


def test_an_observer_who_turns_sees_the_stress_turned(moduli):
    """Q F gives Q sigma Q^T, and the same work and wave speed, to round-off."""
    material, scale = solid(*moduli), moduli[0]
    spins = Rotation.random(5, rng=np.random.default_rng(1)).as_matrix()
    for f, spin in zip(some_deformations(5), spins, strict=True):
        still, moving = one_step(material, f), one_step(material, spin @ f)
        expected = spin @ still.stress[1][FULL] @ spin.T
        assert moving.stress[1][FULL] == pytest.approx(expected, abs=1e-14 * scale * 10)
        assert moving.stress_work[1] == pytest.approx(still.stress_work[1], rel=1e-12)
        assert moving.wave_speed[1] == pytest.approx(still.wave_speed[1], rel=1e-13)


def test_the_wave_speed_along_a_stretched_axis_is_exact(moduli):
    """rho_0 c^2 = F^2 dP/dF under uniaxial strain in tension; c = sqrt((K + 4/3 G) / rho) at rest."""
    first, second = lame(*moduli)
    material, stretch = solid(*moduli), np.array([1.0, 1.1, 1.5])
    history = drive(material, uniaxial_strain(stretch), 1e-3)
    slope = second * (1.0 + stretch**-2) + first * (1.0 - np.log(stretch)) / stretch**2
    assert history.wave_speed == pytest.approx(np.sqrt(stretch**2 * slope / DENSITY), rel=1e-12)
    assert initial_wave_speed(material) == pytest.approx(history.wave_speed[0], rel=1e-14)


def test_no_wave_is_faster_than_the_wave_speed(moduli):
    """It bounds the fastest wave in any direction, by differences of the energy, from above within 12 %."""
    directions = Rotation.random(200, rng=np.random.default_rng(5)).as_matrix()
    h = 1e-3
    for f in some_deformations(5):
        fastest = 0.0
        for n in directions[:, 0]:
            for amplitude in (n, np.cross(n, [0.3, 0.5, 0.8])):
                amplitude = amplitude / np.linalg.norm(amplitude)
                change = np.outer(amplitude, n) @ f * h
                curvature = (
                    energy(f + change, *moduli) - 2.0 * energy(f, *moduli) + energy(f - change, *moduli)
                ) / h**2
                fastest = max(fastest, np.sqrt(curvature / DENSITY))
        assert 0.98 * fastest < one_step(solid(*moduli), f).wave_speed[1] < 1.15 * fastest


@pytest.mark.usefixtures("interpreted")
def test_bulk_viscosity_is_the_shared_one():
    """q = rho h |tr d| (0.06 c + 1.44 h |tr d|) in compression, its work beside that of the stress; none in tension."""
    ratio, dt, length = 0.999, 1e-3, 0.1
    material = solid(1000.0, 0.3)
    path = uniaxial_strain([1.0, ratio, 1.0])
    history = drive(material, path, dt, viscosity=BulkViscosity(), length=length)
    speed = length * 2.0 * (1.0 - ratio) / (dt * (1.0 + ratio))
    expected = DENSITY / ratio * speed * (0.06 * history.wave_speed[1] + 1.44 * speed)
    assert history.fields["viscous_pressure"] == pytest.approx([0.0, expected, 0.0], rel=1e-12)
    assert history.viscous[1:] == pytest.approx(expected * (1.0 - ratio), rel=1e-10)
    assert history.stress_work == pytest.approx([energy(f, 1000.0, 0.3) for f in path], abs=1e-13)


def test_an_inverted_point_is_refused():
    """det F <= 0 ends the drive with step, time and law."""
    with pytest.raises(RunFailure, match=r"step 1, .* inverted .*CompressibleNeoHookean"):
        one_step(solid(1000.0, 0.3), np.diag([-1.0, 1.0, 1.0]))


def test_points_carry_a_stress_and_with_conduction_a_temperature():
    """No state but the stress; a temperature only if the law or the conduction of heat asks for one."""
    bare = MaterialPoints(solid(1000.0, 0.3), np.ones(2))
    warm = MaterialPoints(solid(1000.0, 0.3), np.ones(2), temperature=350.0, conduction=True)
    assert set(bare.fields()) == {"deformation_gradient", "stress"}
    assert set(warm.fields()) == {"deformation_gradient", "stress", "temperature"}
    warm.deformation_gradient[:] = principal_stretches([1.1], [0.9], [1.2])
    warm.advance(1e-3)
    warm.accept()
    assert np.all(warm.old.temperature == 350.0)


@pytest.mark.usefixtures("interpreted")
def test_a_step_without_end_is_one_at_rest():
    """A step of infinite duration brings points to a deformation at no rate: no viscous pressure, the same stress."""
    f = principal_stretches([0.9], [0.95], [1.0])
    points = MaterialPoints(solid(1000.0, 0.3), np.ones(1), viscosity=BulkViscosity())
    points.lengths[:] = 0.1
    points.deformation_gradient[:] = f
    work = points.advance(np.inf)
    assert work.viscous == work.viscous_pressure == 0.0
    assert points.new.stress[0] == pytest.approx(one_step(solid(1000.0, 0.3), f[0]).stress[1], rel=1e-14)


@pytest.mark.parametrize(
    ("young", "poisson"), [(0.0, 0.3), (-1.0, 0.3), (1e3, 0.5), (1e3, -1.0), (np.nan, 0.3)]
)
def test_moduli_of_no_solid_are_refused(young, poisson):
    """E > 0 and -1 < nu < 1/2; the message has the numbers."""
    with pytest.raises(MaterialError, match=r"give E > 0 and -1 < nu < 0.5"):
        IsotropicElastic.from_young(young, poisson)

"""The consistent tangent: the derivative of the step, exactly, in every branch of both updates."""

from dataclasses import replace

import numpy as np
import pytest

from core_models import points as points_module
from core_models.bulk_viscosity import BulkViscosity
from core_models.cards import shipped_materials
from core_models.cards.reader import read_material
from core_models.eos.default_hypo import DefaultHypoelastic
from core_models.eos.neo_hookean import NeoHookean
from core_models.erosion.no_shear import AllowNoShear
from core_models.erosion.no_tension import AllowNoTension
from core_models.erosion.zero_stress import ZeroStress
from core_models.errors import UnsupportedError
from core_models.expansion.isotropic import IsotropicExpansion
from core_models.flow.anand import Anand
from core_models.flow.voce import Voce
from core_models.kernels import advance_points
from core_models.material import Material
from core_models.objective_rate.jaumann import Jaumann
from core_models.objective_rate.logarithmic import Logarithmic
from core_models.points import MaterialPoints, PointFailure
from core_models.threads import Threads
from core_models.updates.compressible_neo_hookean import CompressibleNeoHookean
from core_models.updates.hyperelastic_plastic import HyperelasticPlastic
from core_models.updates.hypoelastic_plastic import HypoelasticPlastic
from core_models.updates.tangent_kernel import linearise_points

TURN = np.array([[0.36, -0.48, 0.8], [0.8, 0.6, 0.0], [-0.48, 0.64, 0.6]])
GRADIENT = np.array([[0.9, 0.35, -0.2], [-0.15, -0.5, 0.4], [0.25, 0.3, -0.3]])
SOFTENING = Voce(400e6, 150e6, 40.0, 0.0)
SOLDER = Anand(39.5e6, 8710.0, 8.75e5, 4.25, 0.207, 3321.2e6, 73.81e6, 0.018, 1.82)
STENCIL = {-2: 1 / 12, -1: -8 / 12, 1: 8 / 12, 2: -1 / 12}
STEP = 2e-4


@pytest.fixture
def plain(monkeypatch):
    """Let points run in plain Python."""
    for name, kernel in (("advance_points", advance_points), ("linearise_points", linearise_points)):
        monkeypatch.setattr(points_module, name, getattr(kernel, "py_func", kernel))


def prepared(material, size, before, dt=1e-4, **changes):
    """A point after the step exp(before GRADIENT), of which state fields are changed, about to make one of a size."""
    points = MaterialPoints(exact(material), np.ones(1))
    if before:
        points.deformation_gradient[0] = np.eye(3) + before * GRADIENT.T
        points.advance(dt)
        points.accept()
    for name, value in changes.items():
        getattr(points.old, name)[0] = value
    points.deformation_gradient[0] = (np.eye(3) + size * GRADIENT) @ points.old_deformation_gradient[0]
    return points


def exact(material):
    """The material with a return to round-off: differences see what its tolerance leaves."""
    if not hasattr(material.update, "tolerance"):
        return material
    return replace(material, update=material.update._replace(tolerance=1e-15))


def linearised(points, dt=1e-4):
    """First Piola stress (3, 3) and tangent (9, 9) of the first point."""
    stresses, tangents = np.empty((points.n, 3, 3)), np.empty((points.n, 9, 9))
    points.linearise(dt, stresses, tangents)
    return stresses[0], tangents[0]


def first_piola(points, dt=1e-4):
    """First Piola stress of the first point after `advance`."""
    points.advance(dt)
    f = points.deformation_gradient[0]
    stress = points.new.stress[0][[[0, 3, 5], [3, 1, 4], [5, 4, 2]]]
    return np.linalg.det(f) * stress @ np.linalg.inv(f).T


def by_differences(points, dt=1e-4, step=STEP):
    """Tangent by central differences of fourth order."""
    centre = points.deformation_gradient[0].copy()
    tangent = np.zeros((9, 9))
    for column in range(9):
        for offset, weight in STENCIL.items():
            points.deformation_gradient[0] = centre
            points.deformation_gradient[0].flat[column] += offset * step
            tangent[:, column] += weight / step * first_piola(points, dt).ravel()
    points.deformation_gradient[0] = centre
    return tangent


def assert_exact(points, dt=1e-4, step=STEP):
    """The tangent agrees with differences to 1e-6 of its largest component; returns it."""
    stress, tangent = linearised(points, dt)
    state = [None if array is None else array.copy() for array in points.new]
    expected = by_differences(points, dt, step)
    assert np.abs(tangent - expected).max() <= 1e-6 * np.abs(expected).max()
    assert stress == pytest.approx(first_piola(points, dt), rel=1e-12)
    for left, right in zip(state, points.new, strict=True):
        assert (left is None and right is None) or np.array_equal(left, right)
    return tangent


@pytest.mark.parametrize("update", ["hypo", "hyper"])
@pytest.mark.parametrize("flow", ["perfect", "linear", "power", "voce", "jc", "mts", SOFTENING, SOLDER])
@pytest.mark.parametrize(("size", "before"), [(1e-2, 0.05), (0.5, 0.0), (0.5, 0.3)])
def test_the_tangent_is_the_derivative_of_a_plastic_step(plain, copper, update, flow, size, before):
    """Every flow law, rate dependence and history included, in small steps and in those of 50 % strain."""
    points = prepared(copper(update, flow), size, before)
    assert_exact(points)
    assert points.new.equivalent_plastic_strain[0] > points.old.equivalent_plastic_strain[0]


@pytest.mark.parametrize("rate", [Logarithmic(), Jaumann()])
@pytest.mark.parametrize("flow", [None, "linear"])
@pytest.mark.parametrize(("size", "before"), [(1e-2, 0.05), (0.5, 0.0), (0.5, 0.3)])
def test_every_objective_rate_has_its_tangent(plain, copper, rate, flow, size, before):
    """Elastic and plastic, with the rotation of the rate's own frame."""
    points = prepared(copper("hypo", flow, objective_rate=rate), size, before)
    points.deformation_gradient[0] = TURN @ points.deformation_gradient[0]
    assert_exact(points)


@pytest.mark.parametrize("name", sorted(shipped_materials()))
@pytest.mark.parametrize("update", [HypoelasticPlastic(), HyperelasticPlastic()])
def test_every_shipped_card_has_its_tangent(plain, name, update):
    """Every flow law, shear modulus, melting law and equation of state of the cards, warm and under pressure."""
    material = read_material(shipped_materials()[name]).material
    eos = NeoHookean(material.eos.bulk_modulus) if type(material.eos) is DefaultHypoelastic else material.eos
    points = prepared(replace(material, update=update, eos=eos), 0.1, 0.2, dt=1e-5)
    points.old.stress[:, :3] -= 2e9
    if points.old.temperature is not None:
        points.old.temperature[:] += 100.0
    assert_exact(points, dt=1e-5)
    assert points.new.equivalent_plastic_strain[0] > points.old.equivalent_plastic_strain[0]


@pytest.mark.parametrize("name", ["hypo-elastic", "hyper-elastic", "hypo-linear", "hyper-linear"])
@pytest.mark.parametrize(("size", "before"), [(1e-3, 0.0), (0.5, 0.0), (0.3, 1e-3)])
def test_the_tangent_is_the_derivative_of_an_elastic_step(plain, pool, name, size, before):
    """Elastic steps, small and large, of elastic materials and of those that do not yield."""
    material = pool[name]
    if material.flow is not None:
        material = replace(material, flow=material.flow._replace(yield_stress=40e9))
    points = prepared(material, size, before)
    assert_exact(points)


@pytest.mark.parametrize("name", ["hypo-jc-hot", "hyper-jc-hot", "hyper-mts-hot", "hypo-elastic"])
@pytest.mark.parametrize("turn", [TURN, TURN.T @ TURN.T])
def test_the_tangent_holds_where_the_step_turns_far(plain, pool, name, turn):
    """Rotations of some 70 and 140 degrees in the step, together with strain."""
    points = prepared(pool[name], 0.1, 0.2)
    points.deformation_gradient[0] = turn @ points.deformation_gradient[0]
    assert_exact(points)


@pytest.mark.parametrize("update", ["hypo", "hyper"])
@pytest.mark.parametrize("size", [0.02, 0.4, -0.3])
def test_the_pressure_follows_the_energy_of_the_step(plain, hot_copper, update, size):
    """Mie-Grüneisen: the work of the step enters the pressure that does it, in compression and in tension."""
    assert_exact(prepared(hot_copper(update, "jc"), size, 0.1, internal_energy=5e9))


@pytest.mark.parametrize("update", ["hypo", "hyper"])
def test_a_warm_body_has_its_tangent(plain, copper, update):
    """Thermal expansion takes part in the slope of the pressure."""
    assert_exact(
        prepared(copper(update, expansion=IsotropicExpansion(1e-4, 294.0)), 0.2, 0.1, temperature=900.0)
    )


@pytest.mark.parametrize("update", ["hypo", "hyper"])
def test_a_melted_point_has_the_stiffness_of_a_fluid(plain, hot_copper, update):
    """Above melting tau = J p 1: a shear changes nothing."""
    points = prepared(hot_copper(update, "jc"), 0.1, 0.1, temperature=1400.0)
    assert_exact(points)
    points = prepared(hot_copper(update, "jc"), 0.0, 0.0, temperature=1400.0)
    assert linearised(points)[1][1, 1] == 0.0


@pytest.mark.parametrize("update", ["hypo", "hyper"])
@pytest.mark.parametrize(
    "erosion", [ZeroStress(), AllowNoShear(), AllowNoTension(), ZeroStress(1e-4), AllowNoTension(1e-4)]
)
@pytest.mark.parametrize("stretch", [-0.05, 0.05])
def test_a_failed_point_has_the_stiffness_that_erosion_leaves(plain, hot_copper, update, erosion, stretch):
    """Points whose damage has reached 1, in compression and in tension."""
    points = prepared(hot_copper(update, "jc", erosion=erosion), 0.02, 0.1, damage=1.1)
    points.deformation_gradient[0] *= 1.0 + stretch
    tangent = linearised(points)[1]
    expected = by_differences(points)
    assert np.abs(tangent - expected).max() <= 1e-6 * max(np.abs(expected).max(), 1.0)


def test_a_neo_hookean_solid_has_its_tangent(plain, copper):
    """dP/dF of the stored energy: exact and symmetric."""
    elasticity = copper("hyper").elasticity
    tangent = assert_exact(prepared(Material("rubber", 1e3, CompressibleNeoHookean(), elasticity), 0.5, 0.3))
    assert tangent == pytest.approx(tangent.T, abs=1e-14 * np.abs(tangent).max())


@pytest.mark.parametrize("name", ["hyper-elastic", "hyper-linear", "hyper-voce"])
def test_the_hyperelastic_tangent_is_symmetric_as_theory_has_it(plain, pool, name):
    """Elastic steps are; plastic ones are but for a term of the size of the strain, the trial's own b."""
    points = prepared(pool[name], 1e-3, 0.0)
    points.deformation_gradient[0] = np.eye(3) + 1e-3 * (GRADIENT + GRADIENT.T)
    tangent = linearised(points)[1]
    asymmetry = np.abs(tangent - tangent.T).max() / np.abs(tangent).max()
    assert asymmetry < (1e-14 if name == "hyper-elastic" else 5e-3)


def test_newton_with_the_tangent_converges_quadratically(plain, pool):
    """A point under a prescribed first Piola stress well beyond yield: the error squares from one step to the next."""
    for name in ("hypo-linear", "hyper-voce"):
        points = prepared(pool[name], 0.03, 0.02)
        goal = first_piola(points)
        points.deformation_gradient[0] += 0.01 * GRADIENT.T @ GRADIENT
        misses = []
        for _iteration in range(6):
            stress, tangent = linearised(points)
            misses.append(np.linalg.norm(stress - goal) / np.linalg.norm(goal))
            # Solutions that differ by a rotation: the least correction picks one.
            correction = np.linalg.lstsq(tangent, (goal - stress).ravel(), rcond=1e-12)[0]
            points.deformation_gradient[0] += correction.reshape(3, 3)
        assert misses[4] < 10.0 * misses[3] ** 2 < 1e-4
        assert misses[5] < 10.0 * misses[4] ** 2


@pytest.mark.parametrize("name", ["hypo-jc-hot", "hyper-linear"])
def test_compiled_tangents_are_those_of_plain_python_for_any_number_of_threads(pool, monkeypatch, name):
    """The same numbers to round-off, the same bits on one and on two threads; points at different strains."""
    sizes = np.linspace(-0.3, 0.5, 600)
    results = []
    for threads in (1, 2):
        points = MaterialPoints(pool[name], np.ones(len(sizes)), threads=Threads(threads))
        points.deformation_gradient[:] += sizes[:, None, None] * GRADIENT
        stresses, tangents = np.empty((points.n, 3, 3)), np.empty((points.n, 9, 9))
        work = points.linearise(1e-4, stresses, tangents)
        results.append((work, stresses.tobytes(), tangents.tobytes(), points.new.stress.tobytes()))
        assert work == points.advance(1e-4)
        assert points.new.stress.tobytes() == results[-1][3]
    assert results[0] == results[1]
    monkeypatch.setattr(
        points_module, "linearise_points", getattr(linearise_points, "py_func", linearise_points)
    )
    few = MaterialPoints(pool[name], np.ones(1))
    few.deformation_gradient[0] += sizes[-1] * GRADIENT
    assert linearised(few)[1] == pytest.approx(tangents[-1], rel=1e-9, abs=1e-9 * np.abs(tangents[-1]).max())


def test_a_tangent_needs_a_step_that_has_one(plain, pool):
    """Bulk viscosity is refused; an inverted point is reported as in an advance."""
    with pytest.raises(UnsupportedError, match="leave the viscosity out"):
        linearised(MaterialPoints(pool["hypo-linear"], np.ones(1), viscosity=BulkViscosity()))
    points = MaterialPoints(pool["hypo-linear"], np.ones(3))
    points.deformation_gradient[1, 0, 0] = -1.0
    with np.errstate(all="ignore"), pytest.raises(PointFailure, match="inverted") as caught:
        linearised(points)
    assert caught.value.point == 1

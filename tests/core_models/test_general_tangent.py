"""The consistent tangent of the general return: the derivative of the step on planes, edges and at the apex."""

from dataclasses import replace

import numpy as np
import pytest

from core_models import points as points_module
from core_models.elasticity.isotropic import IsotropicElastic
from core_models.eos.default_hypo import DefaultHypoelastic
from core_models.eos.neo_hookean import NeoHookean
from core_models.errors import UnsupportedError
from core_models.flow.linear import LinearHardening
from core_models.kernels import advance_points
from core_models.kinematic_hardening.chaboche import Chaboche
from core_models.material import Material
from core_models.objective_rate.jaumann import Jaumann
from core_models.objective_rate.logarithmic import Logarithmic
from core_models.points import MaterialPoints
from core_models.updates.hyperelastic_plastic import HyperelasticPlastic
from core_models.updates.hypoelastic_plastic import HypoelasticPlastic
from core_models.updates.tangent_kernel import linearise_points
from core_models.yield_condition.drucker_prager import DruckerPrager
from core_models.yield_condition.mohr_coulomb import MohrCoulomb
from core_models.yield_condition.von_mises import VonMises

BULK, SHEAR = 1e9, 0.6e9
HARDENING = LinearHardening(1e6, 5e6)
TURN = np.array([[0.36, -0.48, 0.8], [0.8, 0.6, 0.0], [-0.48, 0.64, 0.6]])
BEFORE = np.array([[0.9, 0.35, -0.2], [-0.15, -0.5, 0.4], [0.25, 0.3, -0.3]])
CONES = {
    "cone": (DruckerPrager.from_friction(30, 10), [-0.02, 0.01, 0.005]),
    "apex": (DruckerPrager.from_friction(30, 10), [0.02, 0.011, 0.015]),
    "edge of the cut-off": (DruckerPrager.from_friction(30, 10, "extension", 0.3e6), [0.02, 0.011, 0.015]),
    "plane": (MohrCoulomb(30, 10), [0.01, 0.001, -0.02]),
    "edge in compression": (MohrCoulomb(30, 10), [0.005, 0.005, -0.02]),
    "edge in tension": (MohrCoulomb(30, 10), [0.02, -0.01, -0.0101]),
    "apex of the pyramid": (MohrCoulomb(30, 10), [0.02, 0.011, 0.015]),
    "cut-off": (MohrCoulomb(30, 10, 0.5e6), [0.02, -0.005, -0.006]),
    "where two edges meet": (MohrCoulomb(30, 10, 0.5e6), [0.012, 0.011, -0.012]),
    "corner of the cut-off": (MohrCoulomb(30, 10, 0.5e6), [0.02, 0.018, -0.01]),
}


@pytest.fixture(autouse=True)
def plain(monkeypatch):
    """Let points run in plain Python."""
    for name, kernel in (("advance_points", advance_points), ("linearise_points", linearise_points)):
        monkeypatch.setattr(points_module, name, getattr(kernel, "py_func", kernel))


def soil(update, condition, kinematic=None):
    """A material that returns to round-off: differences see what its tolerance leaves."""
    eos = DefaultHypoelastic(BULK) if update is HypoelasticPlastic else NeoHookean(BULK)
    elastic = IsotropicElastic(BULK, SHEAR)
    return Material(
        "soil", 2000.0, update(1e-14), elastic, eos, HARDENING, condition, kinematic_hardening=kinematic
    )


def first_piola(points):
    """First Piola stress after `advance`."""
    points.advance(1e-4)
    f = points.deformation_gradient[0]
    stress = points.new.stress[0][[[0, 3, 5], [3, 1, 4], [5, 4, 2]]]
    return np.linalg.det(f) * stress @ np.linalg.inv(f).T


def mismatch(material, strain, before=0.004, step=1e-6):
    """Largest difference between the tangent and central differences, over its largest component."""
    points = MaterialPoints(material, np.ones(1))
    points.deformation_gradient[0] += before * BEFORE
    points.advance(1e-4)
    points.accept()
    points.deformation_gradient[0] = (np.eye(3) + strain) @ points.old_deformation_gradient[0]
    stresses, tangents = np.empty((1, 3, 3)), np.empty((1, 9, 9))
    points.linearise(1e-4, stresses, tangents)
    increment = points.new.equivalent_plastic_strain - points.old.equivalent_plastic_strain
    assert increment[0] > 0.0
    assert stresses[0] == pytest.approx(first_piola(points), rel=1e-12)
    centre = points.deformation_gradient[0].copy()
    expected = np.zeros((9, 9))
    for column in range(9):
        for sign in (1.0, -1.0):
            points.deformation_gradient[0] = centre
            points.deformation_gradient[0].flat[column] += sign * step
            expected[:, column] += sign / (2.0 * step) * first_piola(points).ravel()
    return np.abs(tangents[0] - expected).max() / np.abs(expected).max()


@pytest.mark.parametrize("update", [HypoelasticPlastic, HyperelasticPlastic])
@pytest.mark.parametrize("place", CONES)
@pytest.mark.parametrize("turn", [np.eye(3), TURN])
def test_the_tangent_is_the_derivative_everywhere_on_the_surface(update, place, turn):
    """To 1e-6 against central differences, with hardening, along the axes and along others."""
    condition, strains = CONES[place]
    assert mismatch(soil(update, condition), turn @ np.diag(strains) @ turn.T) <= 1e-6


@pytest.mark.parametrize("update", [HypoelasticPlastic, HyperelasticPlastic])
@pytest.mark.parametrize("condition", [DruckerPrager.from_friction(30, 10), MohrCoulomb(30, 10)])
def test_the_tangent_is_the_derivative_from_rest_along_the_axes(update, condition):
    """Where two or three principal trial stresses are equal."""
    for strain in ([-0.02, 0.001, 0.001], [0.02, -0.015, -0.015]):
        assert mismatch(soil(update, condition), np.diag(strain), before=0.0) <= 1e-6


@pytest.mark.parametrize("update", [HypoelasticPlastic, HyperelasticPlastic])
@pytest.mark.parametrize("condition", [VonMises(), DruckerPrager.from_friction(30, 10)])
@pytest.mark.parametrize("size", [0.002, 0.3])
def test_the_tangent_follows_back_stresses(update, condition, size):
    """Their motion, recovery and rotation, in small steps and in those of 30 %."""
    material = soil(update, condition, Chaboche((1e8, 1e7), (50.0, 0.0)))
    assert mismatch(material, size * BEFORE.T, before=0.02) <= 1e-6


@pytest.mark.parametrize("place", ["cone", "apex", "edge of the cut-off"])
@pytest.mark.parametrize("update", [HypoelasticPlastic, HyperelasticPlastic])
def test_the_tangent_is_the_derivative_where_a_moving_cone_ends(update, place):
    """At the apex and at the cut-off the shifted stress is the one that is left."""
    condition, strains = CONES[place]
    material = soil(update, condition, Chaboche((1e8, 1e7), (50.0, 0.0)))
    assert mismatch(material, TURN @ np.diag(strains) @ TURN.T, before=0.02) <= 1e-6


@pytest.mark.parametrize("rate", [Logarithmic(), Jaumann()])
@pytest.mark.parametrize("condition", [VonMises(), DruckerPrager.from_friction(30, 10)])
def test_back_stresses_turn_with_the_objective_rate(rate, condition):
    """The tangent has the spin of the rate's frame, not that of R."""
    hardening = Chaboche((1e8, 1e7), (50.0, 0.0))
    material = replace(soil(HypoelasticPlastic, condition, hardening), objective_rate=rate)
    assert mismatch(material, 0.1 * BEFORE.T, before=0.2) <= 1e-6


def test_arrays_that_cannot_be_filled_are_refused():
    """A copy of a view would be filled and lost: a message says which array to give."""
    points = MaterialPoints(soil(HypoelasticPlastic, VonMises()), np.ones(2))
    stresses, tangents = np.empty((2, 3, 3)), np.empty((2, 9, 9))
    view = np.empty((2, 3, 6))[:, :, ::2]
    for wrong, other in ((view, tangents), (stresses[:1], tangents), (stresses.astype(np.float32), tangents),
                         (stresses, tangents[:, :, ::-1])):  # fmt: skip
        with pytest.raises(UnsupportedError, match=r"give np.empty\(\(2, (3, 3|9, 9)\)\)"):
            points.linearise(1e-3, wrong, other)

"""Fibre-reinforced elasticity: energy, direction, tension only, tangent, and its card."""

from functools import partial

import numpy as np
import pytest
from lxml import etree

import fem
import mpm
from core_models.body_checks import check_orientation
from core_models.cards.reader import parse_material
from core_models.cards.writer import material_element
from core_models.driver import drive
from core_models.elasticity.isotropic import IsotropicElastic
from core_models.errors import MaterialError
from core_models.geometry import GEOMETRIES
from core_models.material import Material
from core_models.points import MaterialPoints
from core_models.updates.compressible_neo_hookean import CompressibleNeoHookean
from core_models.updates.fibre_reinforced import FibreReinforced
from meshes.block import block
from tests.core_models.test_general_tangent import first_piola, plain  # noqa: F401

K1, K2 = 0.5e6, 3.0
FIBRE = (1.0, 2.0, -2.0)
UNIT = np.array(FIBRE) / 3.0
GRADIENT = np.array([[0.09, 0.15, -0.2], [0.1, 0.2, -0.1], [0.05, -0.3, 0.25]])

pytestmark = pytest.mark.usefixtures("interpreted")


def tissue(k2=K2, update=None):
    """A soft matrix with fibres."""
    update = FibreReinforced(K1, k2, FIBRE) if update is None else update
    return Material("tissue", 1e3, update, IsotropicElastic(2e6, 0.3e6))


def piola(material, f):
    """First Piola stress at a deformation gradient."""
    points = MaterialPoints(material, np.ones(1))
    points.deformation_gradient[0] = f
    return first_piola(points)


@pytest.mark.parametrize("k2", [0.0, K2])
def test_fibres_add_the_derivative_of_their_energy(k2):
    """P - P_matrix = 2 W'(I_4) (F a) (x) a, with W differentiated numerically."""
    f = np.eye(3) + GRADIENT
    excess = (f @ UNIT) @ (f @ UNIT) - 1.0
    assert excess > 0.1

    def energy(x):
        return 0.5 * K1 * (np.expm1(k2 * x * x) / k2 if k2 else x * x)

    slope = (energy(excess + 1e-6) - energy(excess - 1e-6)) / 2e-6
    added = piola(tissue(k2), f) - piola(tissue(update=CompressibleNeoHookean()), f)
    assert added == pytest.approx(2.0 * slope * np.outer(f @ UNIT, UNIT), rel=1e-7, abs=1e-6)


def test_compressed_fibres_carry_nothing():
    """Shortened along the fibre the body is its matrix."""
    f = np.eye(3) - 0.2 * np.outer(UNIT, UNIT)
    assert np.array_equal(piola(tissue(), f), piola(tissue(update=CompressibleNeoHookean()), f))


def test_stress_turns_with_the_body():
    """P(Q F) = Q P(F), and a closed path leaves neither stress nor work."""
    turn = np.array([[0.36, -0.48, 0.8], [0.8, 0.6, 0.0], [-0.48, 0.64, 0.6]])
    f = np.eye(3) + GRADIENT
    assert piola(tissue(), turn @ f) == pytest.approx(turn @ piola(tissue(), f), abs=1e-8 * K1)
    history = drive(tissue(), np.array([np.eye(3), f, turn @ f, np.eye(3)]), 1e-3)
    assert history.stress_work[-1] == pytest.approx(0.0, abs=1e-9 * history.stress_work.max())
    assert history.wave_speed[1] > history.wave_speed[0]


@pytest.mark.parametrize("k2", [0.0, K2])
def test_the_tangent_is_the_derivative(plain, k2):  # noqa: F811
    """To 1e-6 against central differences."""
    points = MaterialPoints(tissue(k2), np.ones(1))
    centre = np.eye(3) + GRADIENT
    points.deformation_gradient[0] = centre
    stresses, tangents = np.empty((1, 3, 3)), np.empty((1, 9, 9))
    points.linearise(1e-4, stresses, tangents)
    step = 1e-6
    for column in range(9):
        difference = np.zeros(9)
        for sign in (1.0, -1.0):
            points.deformation_gradient[0] = centre
            points.deformation_gradient[0].flat[column] += sign * step
            difference += sign / (2.0 * step) * first_piola(points).ravel()
        assert tangents[0][:, column] == pytest.approx(difference, abs=1e-6 * np.abs(tangents).max())


def test_fibres_oblique_to_a_plane_body_are_refused():
    """In the plane or normal to it they fit; oblique ones would push the points out of it."""
    check_orientation(tissue(), GEOMETRIES["spatial"])
    for fibre in ((1.0, 2.0, 0.0), (0.0, 0.0, 3.0)):
        check_orientation(tissue(update=FibreReinforced(K1, K2, fibre)), GEOMETRIES["plane-strain"])
    for method in (fem.ExplicitSolver, partial(mpm.Solver, cell_size=0.5)):
        with pytest.raises(MaterialError, match="oblique to the plane"):
            method(block((0.0, 0.0), (1.0, 1.0), (1, 1)), tissue())


def test_card_out_and_in_and_what_is_refused():
    """The card reads back equal; no direction and a flow law are refused."""
    material = tissue()
    again = parse_material(etree.fromstring(etree.tostring(material_element(material))), "tissue").material
    assert again == material
    with pytest.raises(MaterialError, match="give a vector that is not 0"):
        tissue(update=FibreReinforced(K1, K2, (0.0, 0.0, 0.0)))

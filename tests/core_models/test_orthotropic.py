"""Anisotropic linear elasticity: stiffness, orientation, rotation, energy, tangent, wave speeds, and its card."""

import numpy as np
import pytest
from lxml import etree

from core_models.cards.reader import parse_material
from core_models.cards.writer import material_element
from core_models.driver import drive
from core_models.elasticity.isotropic import IsotropicElastic
from core_models.errors import MaterialError
from core_models.material import Material
from core_models.paths import rotations
from core_models.points import MaterialPoints
from core_models.updates.orthotropic import Orthotropic
from tests.core_models.test_general_tangent import first_piola, plain  # noqa: F401

AXES = rotations(np.array([1.0, -2.0, 0.5]), np.array([0.7]))[0]  # rows: the axes of the material
WOOD = Orthotropic(
    12e9, 1.1e9, 0.8e9, 0.5e9, 0.35e9, 0.4e9, 0.2e9, 0.7e9, 0.9e9, tuple(AXES[0]), tuple(3.0 * AXES[1])
)
GRADIENT = np.array([[0.09, 0.15, -0.2], [0.1, 0.2, -0.1], [0.05, -0.3, 0.25]])

pytestmark = pytest.mark.usefixtures("interpreted")


def solid(law=WOOD):
    """A material of the law, with the average moduli of its stiffness."""
    return Material("wood", 600.0, law, IsotropicElastic(*law.averages))


def stiffness(law):
    """C_ijkl [Pa] in the axes of the body, from the nine numbers by Voigt's rule."""
    voigt = np.zeros((6, 6))
    voigt[0, :3] = law.C_11, law.C_12, law.C_31
    voigt[1, :3] = law.C_12, law.C_22, law.C_23
    voigt[2, :3] = law.C_31, law.C_23, law.C_33
    voigt[3:, 3:] = np.diag([law.C_44, law.C_55, law.C_66])
    number = np.array([[0, 5, 4], [5, 1, 3], [4, 3, 2]])
    return np.einsum(
        "ai,bj,ck,dl,abcd->ijkl", AXES, AXES, AXES, AXES, voigt[number[:, :, None, None], number]
    )


def piola(law, f):
    """First Piola stress at a deformation gradient."""
    points = MaterialPoints(solid(law), np.ones(1))
    points.deformation_gradient[0] = f
    return first_piola(points)


def test_stress_is_the_stiffness_times_the_strain():
    """P = F (C : E), with C turned from the axes of the material."""
    f = np.eye(3) + GRADIENT
    strain = 0.5 * (f.T @ f - np.eye(3))
    expected = f @ np.einsum("ijkl,kl", stiffness(WOOD), strain)
    assert piola(WOOD, f) == pytest.approx(expected, abs=1e-12 * np.abs(expected).max())


def test_cubic_crystal_pulled_along_its_axes_and_its_diagonal():
    """Young's moduli of copper's crystal: 66.7 GPa along [100], 130.3 along [110], 191.1 along [111]."""
    for direction, modulus in (((1, 0, 0), 66.7e9), ((1, 1, 0), 130.3e9), ((1, 1, 1), 191.1e9)):
        axis = np.array(direction) / np.linalg.norm(direction)
        crystal = Orthotropic(*[168.4e9] * 3, *[121.4e9] * 3, *[75.4e9] * 3, (1.0, 0.0, 0.0), (0.0, 2.0, 0.0))
        points = MaterialPoints(solid(crystal), np.ones(1))
        stresses, tangents = np.empty((1, 3, 3)), np.empty((1, 9, 9))
        points.linearise(1.0, stresses, tangents)
        flexibility = np.linalg.pinv(tangents[0], rcond=1e-9)
        dyad = np.outer(axis, axis).ravel()
        assert 1.0 / (dyad @ flexibility @ dyad) == pytest.approx(modulus, rel=1e-3)


def test_stress_turns_with_the_body_and_a_closed_path_gives_all_work_back():
    """P(Q F) = Q P(F); no stress and no work at the end of a closed path."""
    turn = np.array([[0.36, -0.48, 0.8], [0.8, 0.6, 0.0], [-0.48, 0.64, 0.6]])
    f = np.eye(3) + GRADIENT
    assert piola(WOOD, turn @ f) == pytest.approx(turn @ piola(WOOD, f), abs=1e-12 * WOOD.C_11)
    history = drive(solid(), np.array([np.eye(3), f, turn @ f, np.eye(3)]), 1e-3)
    strain = 0.5 * (f.T @ f - np.eye(3))
    stored = 0.5 * np.einsum("ij,ijkl,kl", strain, stiffness(WOOD), strain)
    assert history.stress_work[1:] == pytest.approx([stored, stored, 0.0], abs=1e-12 * stored)


def test_the_tangent_is_the_derivative(plain):  # noqa: F811
    """To 1e-6 against central differences."""
    points = MaterialPoints(solid(), np.ones(1))
    centre, step = np.eye(3) + GRADIENT, 1e-6
    points.deformation_gradient[0] = centre
    stresses, tangents = np.empty((1, 3, 3)), np.empty((1, 9, 9))
    points.linearise(1e-4, stresses, tangents)
    for column in range(9):
        difference = np.zeros(9)
        for sign in (1.0, -1.0):
            points.deformation_gradient[0] = centre
            points.deformation_gradient[0].flat[column] += sign * step
            difference += sign / (2.0 * step) * first_piola(points).ravel()
        assert tangents[0][:, column] == pytest.approx(difference, abs=1e-6 * np.abs(tangents).max())


@pytest.mark.parametrize("scale", [0.0, 0.5, 1.0])
def test_the_wave_speed_bounds_that_of_every_direction(scale):
    """The largest eigenvalue of the acoustic tensor over 500 directions is not above rho_0 c^2; near it for wood."""
    f = np.eye(3) + scale * GRADIENT
    history = drive(solid(), np.array([np.eye(3), f]), 1e-3)
    points = MaterialPoints(solid(), np.ones(1))
    points.deformation_gradient[0] = f
    stresses, tangents = np.empty((1, 3, 3)), np.empty((1, 9, 9))
    points.linearise(1e-3, stresses, tangents)
    normals = np.random.default_rng(1).normal(size=(500, 3))
    normals = np.vstack((normals / np.linalg.norm(normals, axis=1)[:, None], AXES)) @ f
    acoustic = np.einsum("nj,ijkl,nl->nik", normals, tangents.reshape(3, 3, 3, 3), normals)
    fastest = np.linalg.eigvalsh(acoustic).max()
    bound = 600.0 * history.wave_speed[-1] ** 2
    assert fastest <= bound * (1.0 + 1e-12)
    assert scale or bound < 1.1 * fastest


def test_card_out_and_in_and_what_is_refused():
    """The card reads back equal; skew axes, an unstable stiffness and other average moduli are refused."""
    again = parse_material(etree.fromstring(etree.tostring(material_element(solid()))), "wood").material
    assert again == solid()
    with pytest.raises(MaterialError, match="two directions at a right angle"):
        solid(WOOD._replace(axis_2=WOOD.axis_1))
    with pytest.raises(MaterialError, match="not positive definite"):
        solid(WOOD._replace(C_23=1.2e9))
    with pytest.raises(MaterialError, match="bulk modulus of the stiffness is .* correct one of them"):
        Material("wood", 600.0, WOOD, IsotropicElastic(2.0 * WOOD.averages[0], WOOD.averages[1]))

"""Anisotropic elasticity: constants recovered, axes, isotropic limit, energy, tangent, wave speed, cards, refusals."""

from contextlib import nullcontext
from dataclasses import replace

import numpy as np
import pytest
from lxml import etree

from core_models.cards.reader import parse_material
from core_models.cards.writer import material_element
from core_models.driver import drive
from core_models.elasticity.cubic import CubicElastic
from core_models.elasticity.isotropic import IsotropicElastic
from core_models.elasticity.orthotropic import OrthotropicElastic
from core_models.elasticity.stiffness import largest_modulus
from core_models.elasticity.transversely_isotropic import TransverselyIsotropicElastic
from core_models.errors import CardError, MaterialError
from core_models.geometry import GEOMETRIES
from core_models.laws import elastic_moduli, stiffness
from core_models.material import Material
from core_models.plane_symmetry import check_plane
from core_models.points import MaterialPoints
from core_models.updates.fibre_reinforced import FibreReinforced
from core_models.updates.hyperelastic_plastic import HyperelasticPlastic
from core_models.updates.st_venant_kirchhoff import StVenantKirchhoff
from tests.core_models.test_general_tangent import first_piola, plain  # noqa: F401

X, Y, Z = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)
SKEW = ((1.0, 2.0, -2.0), (3.0, 0.0, 1.0))
PLY = OrthotropicElastic(140e9, 10e9, 8e9, 0.3, 0.4, 0.25, 5e9, 3e9, 4e9, X, Y)
COPPER = CubicElastic(168.4e9, 121.4e9, 75.4e9, X, Y)
FIBRES = TransverselyIsotropicElastic(140e9, 10e9, 0.3, 0.4, 5e9, X)
LAWS = (PLY._replace(axis_1=SKEW[0], axis_2=SKEW[1]), COPPER._replace(axis_1=SKEW[0], axis_2=SKEW[1]),
        FIBRES._replace(axis=SKEW[0]), IsotropicElastic(136.35e9, 45.45e9))  # fmt: skip
GRADIENT = np.array([[0.09, 0.15, -0.2], [0.1, 0.12, -0.1], [0.05, -0.3, 0.15]])
TURN = np.array([[0.36, -0.48, 0.8], [0.8, 0.6, 0.0], [-0.48, 0.64, 0.6]])
PAIRS = ((0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0))
each_law = pytest.mark.parametrize("law", LAWS, ids=lambda law: type(law).__name__)

pytestmark = pytest.mark.usefixtures("interpreted")


def body(law):
    """A body of this elasticity."""
    return Material("crystal", 1600.0, StVenantKirchhoff(), law)


def piola(law, f):
    """First Piola stress at a deformation gradient."""
    points = MaterialPoints(body(law), np.ones(1))
    points.deformation_gradient[0] = f
    return first_piola(points)


def matrix(law):
    """C (6, 6) [Pa] in x, y, z: second Piola stress of unit Green strains, engineering shear, measured at points."""
    columns = []
    for i, j in PAIRS:
        green = np.zeros((3, 3))
        green[i, j] = green[j, i] = 0.005 if i != j else 0.01
        f = np.linalg.cholesky(np.eye(3) + 2.0 * green).T
        second = np.linalg.solve(f, piola(law, f))
        columns.append([second[pair] / 0.01 for pair in PAIRS])
    return np.array(columns).T


def compliance(law):
    """The inverse of C [1/Pa]."""
    return np.linalg.inv(matrix(law))


def turned(law, turn):
    """The law with its axes turned."""
    axes = {
        name: tuple(turn @ np.array(getattr(law, name))) for name in law._fields if name.startswith("axis")
    }
    return law._replace(**axes)


def test_orthotropic_constants_come_back():
    """Uniaxial and shear stress give E, nu and G of all three axes and planes."""
    s = compliance(PLY)
    assert 1.0 / np.diag(s) == pytest.approx([140e9, 10e9, 8e9, 5e9, 3e9, 4e9], rel=1e-9)
    ratios = (-s[1, 0] / s[0, 0], -s[2, 1] / s[1, 1], -s[2, 0] / s[0, 0])
    assert ratios == pytest.approx((0.3, 0.4, 0.25), rel=1e-9)
    assert matrix(PLY) == pytest.approx(matrix(PLY).T, abs=1.0)


def test_transversely_isotropic_constants_come_back_and_the_plane_has_no_direction():
    """E, nu, G, and nothing changes by a turn about the axis."""
    s = compliance(FIBRES)
    assert 1.0 / np.diag(s) == pytest.approx([140e9, 10e9, 10e9, 5e9, 10e9 / 2.8, 5e9], rel=1e-9)
    assert (-s[1, 0] / s[0, 0], -s[2, 1] / s[1, 1]) == pytest.approx((0.3, 0.4), rel=1e-9)
    f = np.eye(3) + GRADIENT
    turn = np.array([[1.0, 0.0, 0.0], [0.0, 0.6, -0.8], [0.0, 0.8, 0.6]])
    assert turn @ piola(FIBRES, f) @ turn.T == pytest.approx(piola(FIBRES, turn @ f @ turn.T), abs=1.0)


def test_cubic_constants_come_back_and_a_diagonal_has_the_published_modulus():
    """C_11, C_12, C_44; 1 / E = S_11 - 2 (S_11 - S_12 - S_44 / 2) / 3 along [111], 191 GPa for copper."""
    c = matrix(COPPER)
    assert (c[0, 0], c[1, 0], c[3, 3]) == pytest.approx((168.4e9, 121.4e9, 75.4e9), rel=1e-9)
    s11, s12, s44 = (compliance(COPPER)[pair] for pair in ((0, 0), (0, 1), (3, 3)))
    diagonal = COPPER._replace(axis_1=(1.0, np.sqrt(2.0), 0.0), axis_2=(1.0, -np.sqrt(0.5), np.sqrt(1.5)))
    young = 1.0 / compliance(diagonal)[0, 0]
    assert young == pytest.approx(1.0 / (s11 - 2.0 * (s11 - s12 - 0.5 * s44) / 3.0), rel=1e-9)
    assert young == pytest.approx(191e9, rel=5e-3)


def test_a_quarter_turn_swaps_the_axes():
    """About z: 1 and 2 change places, in moduli and in shear."""
    swapped = compliance(PLY._replace(axis_1=Y, axis_2=(-1.0, 0.0, 0.0)))
    assert 1.0 / np.diag(swapped) == pytest.approx([10e9, 140e9, 8e9, 5e9, 4e9, 3e9], rel=1e-9)


@each_law
def test_the_stress_turns_with_the_axes_and_with_the_body(law):
    """P(F Q^T; Q axes) = P(F; axes) Q^T, P(Q F) = Q P(F)."""
    f = np.eye(3) + GRADIENT
    stress = piola(law, f)
    assert piola(turned(law, TURN), f @ TURN.T) == pytest.approx(stress @ TURN.T, abs=1.0)
    assert piola(law, TURN @ f) == pytest.approx(TURN @ stress, abs=1.0)


def test_all_laws_have_the_isotropic_limit():
    """With isotropic constants and any axes the stress is lambda tr(E) 1 + 2 G E."""
    young, poisson = 120e9, 0.3
    isotropic = IsotropicElastic.from_young(young, poisson)
    shear = isotropic.shear_modulus
    lame = isotropic.bulk_modulus - 2.0 / 3.0 * shear
    f = np.eye(3) + GRADIENT
    green = 0.5 * (f.T @ f - np.eye(3))
    expected = f @ (lame * np.trace(green) * np.eye(3) + 2.0 * shear * green)
    alike = (
        isotropic,
        OrthotropicElastic(*[young] * 3, *[poisson] * 3, *[shear] * 3, *SKEW),
        TransverselyIsotropicElastic(young, young, poisson, poisson, shear, SKEW[1]),
        CubicElastic(lame + 2.0 * shear, lame, shear, *SKEW),
    )
    for law in alike:
        assert piola(law, f) == pytest.approx(expected, rel=1e-12, abs=1.0)
        assert elastic_moduli(law) == pytest.approx(tuple(isotropic), rel=1e-12)
        assert largest_modulus(stiffness(law)) == pytest.approx(lame + 2.0 * shear, rel=1e-12)


@each_law
def test_a_closed_path_leaves_neither_stress_nor_work(law):
    """Out, turned, sheared and back."""
    f = np.eye(3) + GRADIENT
    history = drive(body(law), np.array([np.eye(3), f, TURN @ f, f @ f, np.eye(3)]), 1e-3)
    assert history.stress_work[-1] == pytest.approx(0.0, abs=1e-12 * history.stress_work.max())
    assert np.abs(history.stress[-1]).max() == pytest.approx(0.0, abs=1.0)


@each_law
def test_the_tangent_is_the_derivative(plain, law):  # noqa: F811
    """To 1e-6 against central differences, symmetric, and positive where the body has no stress."""
    centre, step = np.eye(3) + GRADIENT, 1e-6
    points = MaterialPoints(body(law), np.ones(1))
    points.deformation_gradient[0] = centre
    stresses, tangents = np.empty((1, 3, 3)), np.empty((1, 9, 9))
    points.linearise(1e-4, stresses, tangents)
    assert tangents[0] == pytest.approx(tangents[0].T, abs=1e-9 * np.abs(tangents).max())
    for column in range(9):
        difference = np.zeros(9)
        for sign in (1.0, -1.0):
            points.deformation_gradient[0] = centre
            points.deformation_gradient[0].flat[column] += sign * step
            difference += sign / (2.0 * step) * first_piola(points).ravel()
        assert tangents[0][:, column] == pytest.approx(difference, abs=1e-6 * np.abs(tangents).max())


@each_law
def test_no_wave_is_faster_than_the_wave_speed(plain, law):  # noqa: F811
    """Above all eigenvalues of the acoustic tensor, deformed and not, and not twice as fast as the fastest."""
    random = np.random.default_rng(5)
    directions = random.normal(size=(300, 3))
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    for f in (np.eye(3), np.eye(3) + GRADIENT, np.diag([0.8, 0.9, 1.1])):
        points = MaterialPoints(body(law), np.ones(1))
        points.deformation_gradient[0] = f
        stresses, tangents = np.empty((1, 3, 3)), np.empty((1, 9, 9))
        points.linearise(1e-4, stresses, tangents)
        moduli = tangents[0].reshape(3, 3, 3, 3)
        pulled = directions @ f  # F^T n
        acoustic = np.einsum("iJkL,nJ,nL->nik", moduli, pulled, pulled)
        fastest = np.sqrt(np.linalg.eigvalsh(acoustic).max() / 1600.0)
        assert fastest <= points.wave_speed[0] * (1.0 + 1e-12) < 2.0 * fastest


@each_law
def test_card_out_and_in(law):
    """The card reads back equal."""
    material = body(law)
    again = parse_material(etree.fromstring(etree.tostring(material_element(material))), "crystal").material
    assert again == material


@pytest.mark.parametrize(
    ("law", "text"),
    [
        (PLY._replace(nu_12=3.8), "nu_12 = 3.8 makes a stiffness that is not positive definite: give it between -3.7"),
        (PLY._replace(nu_12=3.0, nu_13=3.0), "Poisson's ratios together make a stiffness that is not positive"),
        (PLY._replace(axis_2=(-2.0, 0.0, 0.0)), "axis_1 and axis_2 span no plane"),
        (PLY._replace(E_2=-1e9), "E_2 = -1000000000.0 Pa is out of its range"),
        (COPPER._replace(C_12=170e9), "C_12 = 170000000000.0 makes a stiffness that is not positive definite"),
        (FIBRES._replace(axis=(0.0, 0.0, 0.0)), "give a vector that is not 0"),
        (FIBRES._replace(nu_23=1.0), "nu_23 = 1.0 makes a stiffness that is not positive definite"),
    ],
)  # fmt: skip
def test_constants_of_no_solid_are_refused(law, text):
    """By name, with the limit."""
    with pytest.raises(MaterialError) as refused:
        body(law)
    assert text in str(refused.value)


def test_what_does_not_go_with_anisotropy_is_refused():
    """Another update says which one fits; a card with both kinds of moduli says which tag to delete."""
    with pytest.raises(MaterialError, match="or st_venant_kirchhoff for a body that does not flow"):
        replace(body(PLY), update=HyperelasticPlastic())
    element = material_element(body(COPPER))
    etree.SubElement(element.find("constitutive_model"), "bulk_modulus").text = "1e9"
    with pytest.raises(
        CardError, match="<bulk_modulus> stands beside an <elasticity_model>; delete one of them"
    ):
        parse_material(element)
    other = material_element(body(COPPER))
    other.find("constitutive_model").set("type", "compressible_neo_hookean")
    with pytest.raises(MaterialError, match="take the update st_venant_kirchhoff or hypoelastic_plastic"):
        parse_material(other)


@pytest.mark.parametrize(
    ("update", "law", "fits"),
    [
        (
            StVenantKirchhoff(),
            turned(PLY, np.array([[0.6, -0.8, 0.0], [0.8, 0.6, 0.0], [0.0, 0.0, 1.0]])),
            True,
        ),
        (StVenantKirchhoff(), LAWS[0], False),
        (StVenantKirchhoff(), COPPER._replace(axis_1=(1.0, 1.0, 0.0), axis_2=(0.0, 0.0, 3.0)), True),
        (StVenantKirchhoff(), COPPER._replace(axis_1=(1.0, 0.0, 1.0), axis_2=(1.0, 0.0, -1.0)), True),
        (StVenantKirchhoff(), COPPER._replace(axis_1=(2.0, 0.0, 1.0), axis_2=Y), False),
        (StVenantKirchhoff(), FIBRES._replace(axis=Z), True),
        (StVenantKirchhoff(), FIBRES._replace(axis=(0.0, 1.0, 1.0)), False),
        (StVenantKirchhoff(), LAWS[3], True),
        (FibreReinforced(1e9, 1.0, (1.0, 2.0, 0.0)), LAWS[3], True),
        (FibreReinforced(1e9, 1.0, (1.0, 0.0, 1.0)), LAWS[3], False),
    ],
)
def test_a_plane_mesh_lies_in_a_plane_of_symmetry(update, law, fits):
    """Laws that would shear out of the plane are refused there, and not in space."""
    material = Material("crystal", 1600.0, update, law)
    check_plane(material, GEOMETRIES["spatial"])
    for name in ("axisymmetric", "plane-strain"):
        with nullcontext() if fits else pytest.raises(MaterialError, match="normal to the plane"):
            check_plane(material, GEOMETRIES[name])

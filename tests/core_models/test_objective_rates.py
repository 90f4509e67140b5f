"""Objective rates of the hypoelastic update: closed forms of simple shear, objectivity, tangents."""

import itertools

import numpy as np
import pytest

from core_models import points as points_module
from core_models.cards.reader import read_material
from core_models.cards.writer import write_material
from core_models.driver import drive
from core_models.errors import MaterialError
from core_models.kernels import advance_points
from core_models.objective_rate.jaumann import Jaumann
from core_models.objective_rate.logarithmic import Logarithmic
from core_models.paths import simple_shear
from core_models.updates.corotation import corotated, stretching

TURN = np.array([[0.36, -0.48, 0.8], [0.8, 0.6, 0.0], [-0.48, 0.64, 0.6]])
GRADIENT = np.array([[0.9, 0.35, -0.2], [-0.15, -0.5, 0.4], [0.25, 0.3, -0.3]])
RATES = {"green_naghdi": None, "logarithmic": Logarithmic(), "jaumann": Jaumann()}


def green_naghdi(gamma):
    """s12 and s11 over G (Dienes)."""
    b = np.arctan(0.5 * gamma)
    logarithm = np.log(np.cos(b))
    shear = 2.0 * np.cos(2 * b) * (2 * b - 2 * np.tan(2 * b) * logarithm - np.tan(b))
    return shear, 4.0 * (np.cos(2 * b) * logarithm + b * np.sin(2 * b) - np.sin(b) ** 2)


def logarithmic(gamma):
    """s12 and s11 over G."""
    a, root = np.arcsinh(0.5 * gamma), np.sqrt(1.0 + 0.25 * gamma**2)
    return 2.0 * a / root, a * gamma / root


def jaumann(gamma):
    """s12 and s11 over G."""
    return np.sin(gamma), 1.0 - np.cos(gamma)


CLOSED_FORMS = {"green_naghdi": green_naghdi, "logarithmic": logarithmic, "jaumann": jaumann}


@pytest.mark.parametrize(
    ("name", "error"), [("green_naghdi", 6e-5), ("logarithmic", 1e-11), ("jaumann", 1.2e-4)]
)
def test_simple_shear_has_the_closed_form_of_the_rate(interpreted, copper, name, error):
    """Stresses over G up to a shear of 10 in steps of 1/50; of the logarithmic rate to round-off, whatever the step."""
    material = copper("hypo", objective_rate=RATES[name])
    gamma = np.linspace(0.0, 10.0, 501)
    stress = drive(material, simple_shear(gamma), 1.0).stress / 45.45e9
    shear, normal = CLOSED_FORMS[name](gamma)
    assert stress[:, 3] == pytest.approx(shear, abs=error)
    assert stress[:, 0] == pytest.approx(normal, abs=error)
    assert stress[:, 1] == pytest.approx(-stress[:, 0], abs=1e-4)


@pytest.mark.parametrize("name", RATES)
def test_a_rotation_during_a_plastic_step_turns_the_stress_and_nothing_else(interpreted, copper, name):
    """The same steps with another rotation after each, of any size: the stress is turned, to round-off."""
    material = copper("hypo", "linear", objective_rate=RATES[name])
    path, turned = [np.eye(3)], [np.eye(3)]
    turn = np.eye(3)
    for step in range(6):
        turn = TURN @ turn
        path.append((np.eye(3) + 0.1 * (step + 1) * GRADIENT) @ path[-1])
        turned.append(turn @ path[-1])
    stress = full(drive(material, path, 1e-3).stress[-1])
    other = full(drive(material, turned, 1e-3).stress[-1])
    assert other == pytest.approx(turn @ stress @ turn.T, abs=1e-12 * np.abs(stress).max())


def full(stress):
    """Six components as a tensor."""
    return stress[[[0, 3, 5], [3, 1, 4], [5, 4, 2]]]


@pytest.mark.parametrize("scale", [1.0, 4.0])
def test_in_the_logarithmic_frame_the_strain_grows_with_the_rate_of_deformation(scale):
    """The frame's definition: what its strain increment lacks is of second order in the step, for any stretch."""
    before = (scale, 0.5, 1.3, 0.2, 0.1, -0.15)
    change = np.array([0.3, -0.2, 0.1, 0.4, 0.25, -0.35])
    gaps = []
    for size in (1e-3, 1e-4):
        after = tuple(np.array(before) + size * change)
        strain = corotated(Logarithmic(), before, after, (1.0, 0.0, 0.0, 0.0))[0]
        gaps.append(np.abs(np.subtract(strain, stretching(before, after))).max())
    assert gaps[1] < 0.011 * gaps[0] < 1e-6


def test_the_rates_agree_where_the_axes_do_not_turn(interpreted, copper):
    """Stretch along fixed axes: no rate turns the stress."""
    path = np.array([np.diag([1.0 + t, 1.0 - 0.3 * t, 1.0 - 0.4 * t]) for t in np.linspace(0.0, 0.3, 31)])
    stresses = [
        drive(copper("hypo", "linear", objective_rate=rate), path, 1.0).stress for rate in RATES.values()
    ]
    for stress in stresses[1:]:
        assert stress == pytest.approx(stresses[0], rel=1e-6, abs=1e3)


def test_closed_cycles_leave_nothing_with_the_logarithmic_rate_only(interpreted, copper):
    """An elastic square cycle of stretch and shear: the other two rates leave a stress behind."""
    square = [(0.0, 0.0), (0.4, 0.0), (0.4, 0.8), (0.0, 0.8), (0.0, 0.0)]
    corners = [np.array([[1.0 + a, b, 0.0], [0.0, 1.0 - 0.5 * a, 0.0], [0.0, 0.0, 1.0]]) for a, b in square]
    path = [np.eye(3)]
    for first, last in itertools.pairwise(corners):
        path += [first + share * (last - first) for share in np.linspace(0.05, 1.0, 20)]
    left = {
        name: np.abs(drive(copper("hypo", objective_rate=rate), path, 1.0).stress[-1]).max()
        for name, rate in RATES.items()
    }
    assert left["logarithmic"] < 1e-11 * 45.45e9
    assert left["green_naghdi"] > 1e-3 * 45.45e9
    assert left["jaumann"] > 1e-3 * 45.45e9


def test_a_card_states_the_rate(read_card, tmp_path):
    """Read, written and read again; the default needs no tag."""
    card = read_card(("<shear_modulus>", '<objective_rate type="logarithmic"/><shear_modulus>'))
    assert card.material.objective_rate == Logarithmic()
    write_material(card.material, tmp_path / "again.xml")
    assert read_material(tmp_path / "again.xml").material == card.material
    plain_card = read_card(("<shear_modulus>", '<objective_rate type="green_naghdi"/><shear_modulus>'))
    assert plain_card.material == read_card().material


def test_only_the_hypoelastic_update_has_a_rate(copper):
    """The hyperelastic update integrates none: a typed error says what would fit."""
    with pytest.raises(MaterialError, match="leave objective_rate out, or take the hypoelastic update"):
        copper("hyper", objective_rate=Jaumann())


def test_compiled_rates_are_those_of_plain_python(copper, monkeypatch):
    """The logarithmic rate compiled, along simple shear."""
    material, path = copper("hypo", objective_rate=Logarithmic()), simple_shear(np.linspace(0.0, 3.0, 11))
    compiled = drive(material, path, 1.0).stress
    monkeypatch.setattr(points_module, "advance_points", getattr(advance_points, "py_func", advance_points))
    assert compiled == pytest.approx(drive(material, path, 1.0).stress, rel=1e-10, abs=1.0)

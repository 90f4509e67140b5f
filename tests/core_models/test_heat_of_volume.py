"""Thermal expansion, and the heat of compression: closed forms in both updates."""

from dataclasses import replace

import numpy as np
import pytest

from core_models.cards.reader import read_material
from core_models.cards.writer import write_material
from core_models.driver import drive
from core_models.eos.mie_gruneisen import MieGruneisen
from core_models.errors import MaterialError
from core_models.expansion.isotropic import IsotropicExpansion
from core_models.heating.isentropic import IsentropicHeating
from core_models.heating.taylor_quinney import TaylorQuinney
from core_models.points import MaterialPoints
from core_models.specific_heat.constant import ConstantSpecificHeat

BULK, GAMMA = 136.35e9, 2.02
EXPANSION = IsotropicExpansion(1.7e-5, 294.0)
UPDATES = ["hypo", "hyper"]

pytestmark = pytest.mark.usefixtures("interpreted")


def held_at(material, temperature, deformation):
    """Stress (6,) of a point that is brought to a temperature and a deformation."""
    points = MaterialPoints(material, np.ones(1))
    points.old.temperature[0] = temperature
    points.deformation_gradient[0] = deformation
    points.advance(1.0)
    return points.new.stress[0]


def test_a_body_that_is_held_comes_under_pressure(copper):
    """p = 3 K alpha (T - T_0) with the linear pressure, and no shear stress."""
    stress = held_at(copper("hypo", expansion=EXPANSION), 394.0, np.eye(3))
    assert stress == pytest.approx([-3.0 * BULK * 1.7e-5 * 100.0] * 3 + [0.0] * 3, rel=1e-12)


@pytest.mark.parametrize("update", UPDATES)
def test_a_free_body_expands_without_stress(copper, update):
    """F = exp(alpha (T - T_0)) 1, heated and cooled, with flow law and without."""
    for temperature, flow in ((794.0, None), (94.0, "linear")):
        stretch = np.exp(1.7e-5 * (temperature - 294.0))
        stress = held_at(copper(update, flow, expansion=EXPANSION), temperature, stretch * np.eye(3))
        assert np.abs(stress).max() < 1e-15 * BULK


@pytest.mark.parametrize("update", UPDATES)
def test_a_body_that_starts_hot_in_its_shape_starts_under_pressure(copper, update):
    """The first state is that of the first step."""
    material = copper(update, expansion=EXPANSION)
    start = MaterialPoints(material, np.ones(1), temperature=500.0).old.stress[0]
    assert start == pytest.approx(held_at(material, 500.0, np.eye(3)), rel=1e-12)
    assert start[0] < -1e9


@pytest.mark.parametrize("update", UPDATES)
def test_compression_without_flow_follows_the_isentrope(copper, update):
    """T = T_0 exp[Gamma_0 (1 - J)], there and back, whatever the steps."""
    eos = MieGruneisen(8930.0, 3940.0, GAMMA, 1.489)
    material = copper(
        update, "jc", eos=eos, heating=IsentropicHeating(0.9), specific_heat=ConstantSpecificHeat(383.0)
    )
    ratios = np.concatenate([np.linspace(1.0, 0.8, 5), [1.05, 1.0]])
    path = np.cbrt(ratios)[:, None, None] * np.eye(3)
    temperature = drive(material, path, 1e-6).fields["temperature"]
    assert temperature == pytest.approx(294.0 * np.exp(GAMMA * (1.0 - ratios)), rel=1e-13)


@pytest.mark.parametrize("update", UPDATES)
def test_plastic_heat_comes_on_top(copper, update):
    """At constant volume the isentropic law is Taylor and Quinney's, to the last bit."""
    eos = MieGruneisen(8930.0, 3940.0, GAMMA, 1.489)
    shear = np.tile(np.eye(3), (5, 1, 1))
    shear[:, 0, 1] = np.linspace(0.0, 0.4, 5)
    temperatures = [
        drive(
            copper(update, "jc", eos=eos, heating=heating, specific_heat=ConstantSpecificHeat(383.0)),
            shear,
            1e-6,
        ).fields["temperature"]
        for heating in (IsentropicHeating(0.9), TaylorQuinney(0.9))
    ]
    assert np.array_equal(*temperatures)
    assert temperatures[0][-1] > 300.0


def test_what_makes_no_sense_is_refused(copper, hot_copper):
    """Expansion beside an energy that has it, the heat of volume change without a Grüneisen gamma."""
    with pytest.raises(
        MaterialError, match="thermal pressure in its energy: leave the thermal expansion out"
    ):
        hot_copper("hypo", "jc", expansion=EXPANSION)
    with pytest.raises(MaterialError, match="take mie_gruneisen, or the heating taylor_quinney"):
        copper("hyper", "jc", heating=IsentropicHeating(0.9), specific_heat=ConstantSpecificHeat(383.0))


def test_cards_state_both(read_card, copper, tmp_path):
    """The heating in its block; the expansion in a block, or by the plain coefficient of old cards."""
    card = read_card(("<shear_modulus>", '<heating_model type="isentropic"/><shear_modulus>')).material
    assert card.heating == IsentropicHeating(0.9)
    write_material(replace(copper("hypo", expansion=EXPANSION), name="expanding"), tmp_path / "one.xml")
    block = read_material(tmp_path / "one.xml").material
    assert block.expansion == EXPANSION
    text = (tmp_path / "one.xml").read_text()
    start, end = (
        text.index("<thermal_expansion"),
        text.index("</thermal_expansion>") + len("</thermal_expansion>"),
    )
    plain_tag = "<coeff_thermal_expansion>1.7e-5</coeff_thermal_expansion>"
    (tmp_path / "two.xml").write_text(text[:start] + plain_tag + text[end:])
    assert replace(read_material(tmp_path / "two.xml").material, name=block.name) == block

"""What is simulated and what is not: the reasons name the true cause."""

from dataclasses import replace

import pytest

from core_models.cards import read_material, shipped_materials
from core_models.specific_heat.constant import ConstantSpecificHeat


def heating(material):
    """The entry of plastic heating."""
    return next(effect for effect in material.effects() if effect.name == "plastic heating")


def test_heating_says_its_fraction_and_the_tag_it_comes_from(hot_copper):
    """On: the fraction and taylor_quinney_coeff."""
    effect = heating(hot_copper("hypo", "jc"))
    assert effect.on
    assert effect.reason.startswith("0.9 of the plastic work") and "taylor_quinney_coeff" in effect.reason


def test_absent_heating_names_its_own_cause(copper, hot_copper):
    """No flow law, no specific heat, nothing that feels it, or turned off."""
    heat = {"specific_heat": ConstantSpecificHeat(383.0)}
    for material, cause in (
        (copper("hypo"), "no flow law"),
        (copper("hypo", "jc"), "no specific_heat"),
        (copper("hypo", "linear", **heat), "depends on the temperature"),
        (replace(hot_copper("hypo", "jc"), heating=None), "turned off"),
    ):
        assert not heating(material).on and cause in heating(material).reason


@pytest.mark.parametrize(
    "name", ["kinematic hardening", "temperature-dependent shear modulus", "loss of stability"]
)
def test_effects_that_no_card_can_ask_for_are_listed_as_off(copper, name):
    """The list is whole: it also has what is not offered yet."""
    effect = next(effect for effect in copper("hypo", "jc").effects() if effect.name == name)
    assert not effect.on and "none is offered yet" in effect.reason


def test_laws_that_know_of_pressure_say_that_they_do_not_get_it():
    """Strength and melting of Steinberg's copper are those at rest; other cards do not speak of it."""
    name = "copper_ofhc_steinberg_cochran_guinan"
    effects = {effect.name: effect for effect in read_material(shipped_materials()[name]).material.effects()}
    for name in ("strength under pressure", "melting under pressure"):
        assert not effects[name].on and "as at rest" in effects[name].reason
    plain = read_material(shipped_materials()["copper_ofhc_johnson_cook"]).material.effects()
    assert not [effect for effect in plain if "under pressure" in effect.name]

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


@pytest.mark.parametrize("name", ["strength under pressure", "variable shear modulus"])
def test_laws_that_feel_pressure_are_listed(name):
    """Strength and stiffness of Steinberg's copper do, those of Johnson-Cook's do not."""
    for card, is_on in (("steinberg_cochran_guinan", True), ("johnson_cook", False)):
        material = read_material(shipped_materials()[f"copper_ofhc_{card}"]).material
        effect = next(effect for effect in material.effects() if effect.name == name)
        assert effect.on is is_on

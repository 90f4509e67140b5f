"""`matpoint models`: every law is listed and explained."""

import re

import pytest

from core_models.errors import SceneError
from core_models.schema import SLOTS
from studies.laws.model_text import find_models, model_list, model_text

LAWS = [(slot, model) for slot in SLOTS for model in slot.models]


@pytest.mark.parametrize(
    ("slot", "model"), LAWS, ids=[f"{slot.slot}-{model.types[0]}" for slot, model in LAWS]
)
def test_every_law_is_explained(slot, model):
    """Slot, module, equation or statement, source, card block, and every tag with unit, range and help."""
    text = model_text(model.law.__name__)
    assert f"slot {slot.slot}" in text and model.law.__module__ in text
    assert re.search(r"[Ss]ource", text), "no source"
    assert f'<{slot.tags[0]} {slot.attribute}="{model.types[0]}">' in text
    for parameter in model.parameters:
        line = next(line for line in text.splitlines() if line.startswith(f"  <{parameter.tag}> "))
        assert f"[{parameter.unit}]" in line and str(parameter.range) in line
        assert parameter.help in line and parameter.requirement in line


@pytest.mark.parametrize("name", ["IsotropicElastic", "ConstantMelting", "ConstantSpecificHeat"])
def test_laws_of_plain_tags_are_explained_too(name):
    """By their class names, with their tags."""
    assert "plain tags" in model_text(name) and name in model_list()


def test_the_list_has_every_law():
    """Type, class and one line for each; each slot says what a card without its block gets."""
    lines = model_list().splitlines()
    assert "objective_rate  <objective_rate>  (left out: green_naghdi)" in lines
    for _slot, model in LAWS:
        assert any(f"  {model.types[0]}" in line and model.law.__name__ in line for line in lines)


@pytest.mark.parametrize(
    ("name", "classes"),
    [
        ("ptw", {"PrestonTonksWallace", "PrestonShearModulus"}),
        ("mts", {"MechanicalThreshold", "VarshniShearModulus"}),
        ("jc", {"JohnsonCook"}),
        ("GTN", {"Gurson"}),
        ("za", {"ZerilliArmstrong"}),
        ("drucker_prager", {"DruckerPrager"}),
        ("Mohr-Coulomb", {"MohrCoulomb"}),
        ("threshold", {"MechanicalThreshold"}),
        ("constant_Tm", {"ConstantMelting"}),
        ("green-naghdi", {"HypoelasticPlastic"}),
    ],
)
def test_short_names_are_understood(name, classes):
    """Initials, the beginning of a card's type, parts, in any case; what a card gets without a block."""
    assert {model.law.__name__ for _slot, model in find_models(name)} == classes


def test_a_wrong_name_gets_the_nearest_and_no_list_of_a_hundred():
    """One line, with what it may have meant."""
    with pytest.raises(
        SceneError, match=r"no law 'jonson_cook'; did you mean 'johnson_cook'.*lists all$"
    ) as told:
        find_models("jonson_cook")
    assert len(str(told.value)) < 160
    with pytest.raises(SceneError, match="^no law 'xyzzy'; `matpoint models` lists all$"):
        find_models("xyzzy")

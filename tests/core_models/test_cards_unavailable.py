"""Known models and effects that are not available: refused by name."""

from pathlib import Path

import pytest

from core_models.errors import UnsupportedError

CARD = (Path(__file__).parent / "good_card.xml").read_text()
EOS = '<equation_of_state type="mie_gruneisen">'
FLOW = '<plasticity_model type="johnson_cook">'
MODEL = '<constitutive_model type="hypoelastic_plastic">'


@pytest.mark.parametrize(
    ("block", "types"),
    [
        (FLOW, ["zerilli_armstrong_polymer", "suvic_i"]),
        (EOS, ["mie_gruneisen_energy"]),
        ('<damage_model type="johnson_cook">', ["Threshold", "Brittle"]),
        (MODEL, ["comp_neo_hook_plastic", "visco_plastic"]),
    ],
)
def test_known_but_unavailable_model_says_so(refused, block, types):
    """What is known but not there yet is an UnsupportedError with the list of what is."""
    line = CARD.split(block)[0].count("\n") + 1
    for name in types:
        changed = block.split('"')[0] + f'"{name}">'
        message = refused(UnsupportedError, line, (block, changed))
        assert f"'{name}'" in message
        assert "take one of " in message


@pytest.mark.parametrize(
    "block",
    [
        '<stability_check type="drucker_becker"/>',
        '<melting_temp_model type="linear_Tm"/>',
        '<specific_heat_model type="cubic_Cp"/>',
        '<erosion algorithm="RemoveMass"/>',
        "<evolve_porosity>true</evolve_porosity>",
    ],
)
def test_known_but_unavailable_effect_says_so(refused, block):
    """An effect that would silently be missing is refused."""
    message = refused(UnsupportedError, 7, ("<tolerance>1e-10</tolerance>", block))
    assert "not available" in message


def test_switches_of_old_decks_are_read_where_they_change_nothing(read_card):
    """What they say is done here anyway; tags of decks that do nothing are told."""
    switches = (
        "<isothermal> false </isothermal><do_melting>true</do_melting><evolve_porosity>false</evolve_porosity>"
        "<check_TEPLA_failure_criterion>false</check_TEPLA_failure_criterion>"
        "<plastic_convergence_algo>radialReturn</plastic_convergence_algo>"
        "<initial_material_temperature>696.0</initial_material_temperature><critical_stress>129e9</critical_stress>"
    )
    tolerance = "<tolerance>1e-10</tolerance>"
    card = read_card((tolerance, tolerance + switches))
    assert card.material == read_card().material
    assert {"initial_material_temperature", "critical_stress"} <= {tag.tag for tag in card.unused}


@pytest.mark.parametrize(
    ("tag", "word", "remedy"),
    [
        ("isothermal", "true", "give false"),
        ("do_melting", "false", "give true"),
        ("check_TEPLA_failure_criterion", "maybe", "give false"),
        ("plastic_convergence_algo", "biswajit", "give radialReturn"),
    ],
)
def test_switches_that_would_change_something_are_refused(refused, tag, word, remedy):
    """The message has the word, and the one that is possible."""
    message = refused(UnsupportedError, 7, ("<tolerance>1e-10</tolerance>", f"<{tag}>{word}</{tag}>"))
    assert f"'{word}'" in message and remedy in message

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
        '<yield_condition type="gurson"/>',
        '<stability_check type="drucker"/>',
        '<stability_check type="becker"/>',
        '<melting_temp_model type="linear_Tm"/>',
        '<specific_heat_model type="cubic_Cp"/>',
        '<erosion algorithm="PreserveStress"/>',
        '<erosion algorithm="ZeroStress"><char_time>1e-6</char_time></erosion>',
        "<coeff_thermal_expansion>1e-5</coeff_thermal_expansion>",
        "<evolve_porosity>true</evolve_porosity>",
    ],
)
def test_known_but_unavailable_effect_says_so(refused, block):
    """An effect that would silently be missing is refused."""
    message = refused(UnsupportedError, 7, ("<tolerance>1e-10</tolerance>", block))
    assert "not available" in message

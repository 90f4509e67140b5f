"""What a card means: defaults, places, old and new tags."""

from pathlib import Path

import pytest

from core_models.cards import read_material
from core_models.errors import CardError, MaterialError
from core_models.heating.taylor_quinney import TaylorQuinney

CARD = (Path(__file__).parent / "good_card.xml").read_text()
M = "<m>1.09</m>"
EOS = '<equation_of_state type="mie_gruneisen">'
FLOW = '<plasticity_model type="johnson_cook">'
MODEL = '<constitutive_model type="hypoelastic_plastic">'


def test_johnson_cook_needs_its_temperatures(read_card, refused):
    """T_r and T_m are never assumed: from the block, else from the card, else an error."""
    message = refused(CardError, 9, ("<melt_temp>1356.0</melt_temp>\n", ""))
    assert "lacks <T_m>" in message
    assert "add <T_m> here or <melt_temp> to the card" in message
    given = read_card((M, M + "<T_r>300</T_r><T_m>1300</T_m>")).material
    assert (given.flow.T_r, given.flow.T_m) == (300.0, 1300.0)
    assert (given.damage.T_r, given.damage.T_m) == (294.0, 1356.0)


@pytest.mark.parametrize(
    "block",
    [
        '<stability_check type="none"/>',
        '<kinematic_hardening_model type="none"/>',
        '<shear_modulus_model type="constant_shear"/>',
        '<melting_temp_model type="constant_Tm"></melting_temp_model>',
        '<specific_heat_model type="constant_Cp"/>',
        '<yield_condition type="vonMises"/>',
        '<erosion algorithm="none"/>',
        "<coeff_thermal_expansion>0.0</coeff_thermal_expansion>",
        "<taylor_quinney_coeff>0.9</taylor_quinney_coeff>",
        '<heating_model type="taylor_quinney"/>',
    ],
)
def test_what_says_the_default_changes_nothing(read_card, block):
    """Blocks that switch nothing on are accepted."""
    plain = read_card().material
    assert read_card(("<tolerance>1e-10</tolerance>", block)).material == plain


@pytest.mark.parametrize("name", ["ZeroStress", "AllowNoTension", "AllowNoShear"])
@pytest.mark.parametrize("place", ["</material>", "</constitutive_model>"])
def test_erosion_acts_only_where_a_card_asks(read_card, name, place):
    """The erosion element switches damage's effect on the stress on, at once."""
    block = f'<erosion algorithm="{name}"><char_time>1e-99</char_time></erosion>'
    assert type(read_card((place, block + place)).material.erosion).__name__ == name
    assert read_card().material.erosion is None


def test_damage_model_may_stand_at_either_level(read_card):
    """The seed has it inside the constitutive model, later decks beside it."""
    start, end = CARD.index("<damage_model"), CARD.index("</damage_model>") + len("</damage_model>")
    block = CARD[start:end]
    moved = read_card((block, ""), ("</material>", block + "</material>"))
    assert moved.material == read_card().material


def test_laws_that_do_not_fit_are_refused_with_the_cards_name(refused):
    """Incompatible models, which the founding system let pass, name the card."""
    start, end = CARD.index(EOS), CARD.index("</equation_of_state>") + len("</equation_of_state>")
    message = refused(
        MaterialError,
        6,
        (MODEL, MODEL.replace("hypoelastic", "hyperelastic")),
        (CARD[start:end], '<equation_of_state type="default_hypo"/>'),
    )
    assert "default_hypo" in message


def test_laws_without_meaning_at_room_temperature_are_refused(refused):
    """A flow stress above the shear modulus at room temperature is a MaterialError that names the card."""
    extreme = MTS.replace("<sigma_a>40e6<", "<sigma_a>60e9<")
    assert "initial flow stress" in refused(MaterialError, 10, (JOHNSON_COOK, extreme))


def test_heating_can_be_set_and_switched_off(read_card, refused):
    """taylor_quinney_coeff sets the fraction, a heating model of type none switches heating off; not both."""
    tolerance = "<tolerance>1e-10</tolerance>"
    off = '<heating_model type="none"/>'
    half = "<taylor_quinney_coeff>0.5</taylor_quinney_coeff>"
    assert read_card((tolerance, half)).material.heating == TaylorQuinney(0.5)
    assert read_card((tolerance, off)).material.heating is None
    assert "beside a <heating_model>" in refused(CardError, 7, (tolerance, off + half))
    no_heat = ("<specific_heat>383.0</specific_heat>", "")
    assert "heats nothing" in refused(CardError, 7, (tolerance, half), no_heat)
    assert read_card(no_heat).material.heating is None


MTS = """<plasticity_model type="mts_model">
<sigma_a>40e6</sigma_a><koverbcubed>0.823e6</koverbcubed><edot_0e>1e7</edot_0e><g_0e>1.6</g_0e><q_e>1</q_e>
<p_e>0.666667</p_e><alpha>2</alpha><edot_es0>1e7</edot_es0><g_0es>0.2625</g_0es><sigma_es0>770e6</sigma_es0>
<a_0>2390e6</a_0><a_1>12e6</a_1><a_2>1.696e6</a_2><a_3>0</a_3><theta_IV>0</theta_IV>
<mu_0>47.7e9</mu_0><D>3e9</D><T_0>180</T_0>
<sigma_i>0</sigma_i><g_0i>0</g_0i><edot_0i>0</edot_0i><p_i>0</p_i><q_i>0</q_i>
</plasticity_model>"""
JOHNSON_COOK = CARD[CARD.index(FLOW) : CARD.index("</plasticity_model>") + len("</plasticity_model>")]


def test_modern_mts_card_keeps_one_modulus(read_card):
    """Modern tags are read; where a card has no b1 of its own, mu_0 is the 0 K modulus."""
    flow = read_card((JOHNSON_COOK, MTS)).material.flow
    assert (flow.b1, flow.b2, flow.b3, flow.mu_0) == (47.7e9, 3e9, 180.0, 47.7e9)
    assert (flow.sigma_a, flow.g_0es, flow.theta_IV) == (40e6, 0.2625, 0.0)


def test_mts_barrier_needs_all_its_numbers(refused):
    """Half an intrinsic barrier is refused, not left out."""
    hot = MTS.replace("<sigma_i>0<", "<sigma_i>1341e6<")
    assert "a sigma_i needs g_0i" in refused(CardError, 10, (JOHNSON_COOK, hot))


def test_old_and_new_name_of_one_tag_are_a_duplicate(refused):
    """A value given under two names is refused."""
    twice = MTS.replace("<sigma_a>", "<s_a>1</s_a><sigma_a>")
    assert "given twice" in refused(CardError, 11, (JOHNSON_COOK, twice))


def test_name_comes_from_the_caller_then_the_card_then_the_file(read_card, tmp_path):
    """A material's name is never empty."""
    assert read_card().material.name == "card"
    assert read_card(("<material>", '<material name="copper">')).material.name == "copper"
    assert read_material(tmp_path / "card.xml", name="mine").material.name == "mine"

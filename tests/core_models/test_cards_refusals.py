"""Bad cards: each refused with file, line, wrong value and remedy."""

import pytest

from core_models.cards import read_material
from core_models.errors import CardError, MaterialError, UnsupportedError
from core_models.heating.taylor_quinney import TaylorQuinney

CARD = """<material>
<density>8930.0</density>
<specific_heat>383.0</specific_heat>
<room_temp>294.0</room_temp>
<melt_temp>1356.0</melt_temp>
<constitutive_model type="hypoelastic_plastic">
<tolerance>1e-10</tolerance>
<bulk_modulus>136.35e9</bulk_modulus>
<shear_modulus>45.45e9</shear_modulus>
<plasticity_model type="johnson_cook">
<A>89.6e6</A> <B>292.0e6</B> <C>0.025</C> <n>0.31</n>
<m>1.09</m>
</plasticity_model>
<damage_model type="johnson_cook">
<D1>0.54</D1> <D2>4.89</D2> <D3>-3.03</D3> <D4>0.014</D4> <D5>1.12</D5>
</damage_model>
<equation_of_state type="mie_gruneisen">
<C_0>3940</C_0> <Gamma_0>2.02</Gamma_0> <S_alpha>1.489</S_alpha>
</equation_of_state>
</constitutive_model>
<geom_object>
<cylinder label="c"> <bottom>[0,0,0]</bottom> <top>[0,1,0]</top> <radius>0.5</radius> </cylinder>
<velocity>[0,-1,0]</velocity>
<temperature>294</temperature>
</geom_object>
</material>
"""
M = "<m>1.09</m>"
DENSITY = "<density>8930.0</density>"
EOS = '<equation_of_state type="mie_gruneisen">'
FLOW = '<plasticity_model type="johnson_cook">'
MODEL = '<constitutive_model type="hypoelastic_plastic">'


def read(tmp_path, *changes):
    text = CARD
    for old, new in changes:
        assert text.count(old) == 1
        text = text.replace(old, new)
    path = tmp_path / "card.xml"
    path.write_text(text)
    return read_material(path)


def refused(tmp_path, kind, line, *changes):
    with pytest.raises(kind) as caught:
        read(tmp_path, *changes)
    message = str(caught.value)
    assert type(caught.value) is kind
    assert message.startswith(f"{tmp_path}/card.xml:{line}: ")
    assert "\n" not in message
    assert ";" in message or ":" in message
    return message


def test_the_card_itself_is_good(tmp_path):
    """The card that the other tests break is read."""
    assert read(tmp_path).material.flow.T_m == 1356.0


@pytest.mark.parametrize(
    ("line", "old", "new", "said"),
    [
        (2, DENSITY, "<density>-8930.0</density>", ("-8930.0 kg/m^3", "give a value > 0")),
        (2, DENSITY, "<density>0</density>", ("give a value > 0",)),
        (2, DENSITY, "<density>nan</density>", ("'nan'", "no number")),
        (2, DENSITY, "<density>1.3-11</density>", ("'1.3-11'", "did you mean 1.3e-11?")),
        (2, DENSITY, "<density/>", ("no number",)),
        (2, DENSITY, "<density><x/></density>", ("holds <x>", "number only")),
        (2, DENSITY, '<density unit="SI">1</density>', ("unknown attribute unit",)),
        (2, DENSITY, "<densty>8930</densty>", ("unknown tag <densty>", "did you mean density?", "melt_temp")),
        (3, DENSITY, DENSITY + "\n" + DENSITY, ("<density> is given twice", "card.xml:2")),
        (1, DENSITY, "", ("lacks <density>", "add <density>")),
        (2, DENSITY, DENSITY + "junk", ("stray text 'junk'",)),
        (5, "<melt_temp>1356.0", "<melt_temp>200.0", ("200.0", "294.0", "give melt_temp above room_temp")),
        (3, "<specific_heat>383.0", "<specific_heat>0.0", ("<specific_heat> is 0.0", "give a value > 0")),
        (6, MODEL, "<constitutive_model>", ("has no type", "hypoelastic_plastic")),
        (
            6,
            MODEL,
            MODEL.replace("hypo", "hypr"),
            ("'hyprelastic_plastic'", "did you mean hyperelastic_plastic?"),
        ),
        (6, MODEL, MODEL.replace("type", "typ"), ("unknown attribute typ", "did you mean type?")),
        (7, "<tolerance>1e-10", "<tolerance>0.5", ("out of its range", "<= 0.001")),
        (6, "<bulk_modulus>136.35e9</bulk_modulus>", "", ("lacks <bulk_modulus>",)),
        (9, "<shear_modulus>45", "<shear_modulus>-45", ("-45450000000.0 Pa",)),
        (10, FLOW, FLOW.replace("cook", "cok"), ("'johnson_cok'", "did you mean johnson_cook?", "mts_model")),
        (10, M, "", ("lacks <m>", "add <m>")),
        (12, M, M.replace("m>", "mm>"), ("unknown tag <mm>", "did you mean m?")),
        (12, M, M + "<T_m>200</T_m>", ("T_m = 200.0", "T_r = 294.0")),
        (17, EOS, EOS.replace("gruneisen", "grueneisen"), ("did you mean mie_gruneisen?",)),
        (17, EOS, EOS + "<C_0>1</C_0>", ("given twice",)),
        (20, "</constitutive_model>", "<damage_model type='none'/></constitutive_model>", ("given twice",)),
        (20, "</constitutive_model>", "</constitutive_model><damage_model type='none'/>", ("given twice",)),
        (20, "</constitutive_model>", "<flow_model type='none'/></constitutive_model>", ("given twice",)),
        (20, "</constitutive_model>", "<yield_condition/></constitutive_model>", ("has no type", "vonMises")),
        (22, "<radius>0.5", "<radius>-0.5", ("-0.5 m",)),
        (22, "[0,1,0]", "[0,0,0]", ("one point",)),
        (22, "[0,1,0]", "[0,1]", ("'[0,1]'", "write 3 numbers")),
        (22, "[0,1,0]", "0,1,0", ("write 3 numbers",)),
        (22, "[0,1,0]", "[0,1,nan]", ("'nan'",)),
        (22, 'label="c"', 'lable="c"', ("did you mean label?",)),
        (23, "[0,-1,0]</velocity>", "[0,-1,0]</velocity><res>[1,1,1.5]</res>", ("whole numbers",)),
        (21, "<velocity>[0,-1,0]</velocity>", "", ("lacks <velocity>",)),
    ],
)
def test_bad_card_is_refused(tmp_path, line, old, new, said):
    """Each bad input gives a one-line CardError: file, line, wrong value, remedy."""
    message = refused(tmp_path, CardError, line, (old, new))
    for part in said:
        assert part in message


def test_material_without_its_model_is_refused(tmp_path):
    """Missing required blocks are named, with what they may be."""
    path = tmp_path / "card.xml"
    path.write_text("<material><density>1</density></material>")
    with pytest.raises(CardError, match="lacks <constitutive_model>; add one of type hypoelastic_plastic"):
        read_material(path)
    path.write_text('<material><constitutive_model type="hypoelastic_plastic"/></material>')
    with pytest.raises(CardError, match="lacks <density>"):
        read_material(path)


def test_flow_left_out_is_refused_and_none_is_elastic(tmp_path):
    """A forgotten flow law is no elastic material; an elastic material says so."""
    elastic = '<material><density>1</density><constitutive_model type="hypoelastic_plastic">%s</constitutive_model></material>'
    moduli = "<bulk_modulus>2</bulk_modulus><shear_modulus>1</shear_modulus>"
    path = tmp_path / "card.xml"
    path.write_text(elastic % moduli)
    with pytest.raises(CardError, match="lacks <plasticity_model>; add one of type perfect, .*none"):
        read_material(path)
    path.write_text(elastic % (moduli + '<flow_model type="none"/>'))
    material = read_material(path).material
    assert material.flow is None
    assert material.yield_condition is None


def test_other_root_is_refused(tmp_path):
    """A whole deck or an included file is no material document."""
    path = tmp_path / "card.xml"
    path.write_text("<Uintah_specification/>")
    with pytest.raises(CardError, match="card.xml:1: the root is <Uintah_specification>; .* <material>"):
        read_material(path)


def test_johnson_cook_needs_its_temperatures(tmp_path):
    """T_r and T_m are never assumed: from the block, else from the card, else an error."""
    message = refused(tmp_path, CardError, 9, ("<melt_temp>1356.0</melt_temp>\n", ""))
    assert "lacks <T_m>" in message
    assert "add <T_m> here or <melt_temp> to the card" in message
    given = read(tmp_path, (M, M + "<T_r>300</T_r><T_m>1300</T_m>")).material
    assert (given.flow.T_r, given.flow.T_m) == (300.0, 1300.0)
    assert (given.damage.T_r, given.damage.T_m) == (294.0, 1356.0)


@pytest.mark.parametrize(
    ("block", "types"),
    [
        (FLOW, ["zerilli_armstrong", "steinberg_cochran_guinan", "preston_tonks_wallace"]),
        (EOS, ["mie_gruneisen_energy"]),
        ('<damage_model type="johnson_cook">', ["hancock_mackenzie", "Threshold", "Brittle"]),
        (MODEL, ["comp_neo_hook_plastic", "visco_plastic"]),
    ],
)
def test_known_but_unavailable_model_says_so(tmp_path, block, types):
    """What is known but not there yet is an UnsupportedError with the list of what is."""
    line = CARD.split(block)[0].count("\n") + 1
    for name in types:
        changed = block.split('"')[0] + f'"{name}">'
        message = refused(tmp_path, UnsupportedError, line, (block, changed))
        assert f"'{name}'" in message
        assert "take one of " in message


@pytest.mark.parametrize(
    "block",
    [
        '<yield_condition type="gurson"/>',
        '<stability_check type="drucker"/>',
        '<stability_check type="becker"/>',
        '<shear_modulus_model type="np_shear"/>',
        '<shear_modulus_model type="mts_shear"/>',
        '<shear_modulus_model type="ptw_shear"/>',
        '<shear_modulus_model type="scg_shear"/>',
        '<melting_temp_model type="linear_Tm"/>',
        '<melting_temp_model type="scg_Tm"/>',
        '<melting_temp_model type="bps_Tm"/>',
        '<specific_heat_model type="copper_Cp"/>',
        '<specific_heat_model type="steel_Cp"/>',
        '<kinematic_hardening_model type="prager_hardening"/>',
        '<kinematic_hardening_model type="armstrong_frederick_hardening"/>',
        '<erosion algorithm="PreserveStress"/>',
        '<erosion algorithm="ZeroStress"><char_time>1e-6</char_time></erosion>',
        "<coeff_thermal_expansion>1e-5</coeff_thermal_expansion>",
        "<evolve_porosity>true</evolve_porosity>",
    ],
)
def test_known_but_unavailable_effect_says_so(tmp_path, block):
    """An effect that would silently be missing is refused."""
    message = refused(tmp_path, UnsupportedError, 7, ("<tolerance>1e-10</tolerance>", block))
    assert "not available" in message


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
def test_what_says_the_default_changes_nothing(tmp_path, block):
    """Blocks that switch nothing on are accepted."""
    plain = read(tmp_path).material
    assert read(tmp_path, ("<tolerance>1e-10</tolerance>", block)).material == plain


@pytest.mark.parametrize("name", ["ZeroStress", "AllowNoTension", "AllowNoShear"])
@pytest.mark.parametrize("place", ["</material>", "</constitutive_model>"])
def test_erosion_acts_only_where_a_card_asks(tmp_path, name, place):
    """The erosion element switches damage's effect on the stress on, at once."""
    block = f'<erosion algorithm="{name}"><char_time>1e-99</char_time></erosion>'
    assert type(read(tmp_path, (place, block + place)).material.erosion).__name__ == name
    assert read(tmp_path).material.erosion is None


def test_damage_model_may_stand_at_either_level(tmp_path):
    """The seed has it inside the constitutive model, later decks beside it."""
    start, end = CARD.index("<damage_model"), CARD.index("</damage_model>") + len("</damage_model>")
    block = CARD[start:end]
    moved = read(tmp_path, (block, ""), ("</material>", block + "</material>"))
    assert moved.material == read(tmp_path).material


def test_laws_that_do_not_fit_are_refused_with_the_cards_name(tmp_path):
    """Incompatible models, which the founding system let pass, name the card."""
    start, end = CARD.index(EOS), CARD.index("</equation_of_state>") + len("</equation_of_state>")
    message = refused(
        tmp_path,
        MaterialError,
        6,
        (MODEL, MODEL.replace("hypoelastic", "hyperelastic")),
        (CARD[start:end], '<equation_of_state type="default_hypo"/>'),
    )
    assert "default_hypo" in message


def test_heating_can_be_set_and_switched_off(tmp_path):
    """taylor_quinney_coeff sets the fraction, a heating model of type none switches heating off; not both."""
    tolerance = "<tolerance>1e-10</tolerance>"
    off = '<heating_model type="none"/>'
    half = "<taylor_quinney_coeff>0.5</taylor_quinney_coeff>"
    assert read(tmp_path, (tolerance, half)).material.heating == TaylorQuinney(0.5)
    assert read(tmp_path, (tolerance, off)).material.heating is None
    assert "beside a <heating_model>" in refused(tmp_path, CardError, 7, (tolerance, off + half))
    no_heat = ("<specific_heat>383.0</specific_heat>", "")
    assert "heats nothing" in refused(tmp_path, CardError, 7, (tolerance, half), no_heat)
    assert read(tmp_path, no_heat).material.heating is None


MTS = """<plasticity_model type="mts_model">
<sigma_a>40e6</sigma_a><koverbcubed>0.823e6</koverbcubed><edot_0e>1e7</edot_0e><g_0e>1.6</g_0e><q_e>1</q_e>
<p_e>0.666667</p_e><alpha>2</alpha><edot_es0>1e7</edot_es0><g_0es>0.2625</g_0es><sigma_es0>770e6</sigma_es0>
<a_0>2390e6</a_0><a_1>12e6</a_1><a_2>1.696e6</a_2><a_3>0</a_3><theta_IV>0</theta_IV>
<mu_0>47.7e9</mu_0><D>3e9</D><T_0>180</T_0>
<sigma_i>0</sigma_i><g_0i>0</g_0i><edot_0i>0</edot_0i><p_i>0</p_i><q_i>0</q_i>
</plasticity_model>"""
JOHNSON_COOK = CARD[CARD.index(FLOW) : CARD.index("</plasticity_model>") + len("</plasticity_model>")]


def test_modern_mts_card_keeps_one_modulus(tmp_path):
    """Modern tags are read; where a card has no b1 of its own, mu_0 is the 0 K modulus."""
    flow = read(tmp_path, (JOHNSON_COOK, MTS)).material.flow
    assert (flow.b1, flow.b2, flow.b3, flow.mu_0) == (47.7e9, 3e9, 180.0, 47.7e9)
    assert (flow.sigma_a, flow.g_0es, flow.theta_IV) == (40e6, 0.2625, 0.0)


def test_mts_barriers_that_are_not_there_are_refused(tmp_path):
    """An intrinsic barrier is refused by name, not left out."""
    hot = MTS.replace("<sigma_i>0<", "<sigma_i>1341e6<")
    assert "intrinsic barrier" in refused(tmp_path, UnsupportedError, 15, (JOHNSON_COOK, hot))


def test_old_and_new_name_of_one_tag_are_a_duplicate(tmp_path):
    """A value given under two names is refused."""
    twice = MTS.replace("<sigma_a>", "<s_a>1</s_a><sigma_a>")
    assert "given twice" in refused(tmp_path, CardError, 11, (JOHNSON_COOK, twice))


def test_name_comes_from_the_caller_then_the_card_then_the_file(tmp_path):
    """A material's name is never empty."""
    assert read(tmp_path).material.name == "card"
    assert read(tmp_path, ("<material>", '<material name="copper">')).material.name == "copper"
    assert read_material(tmp_path / "card.xml", name="mine").material.name == "mine"

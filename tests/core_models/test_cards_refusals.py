"""Bad cards: each refused with file, line, wrong value and remedy."""

from pathlib import Path

import pytest

from core_models.cards import read_material
from core_models.errors import CardError

CARD = (Path(__file__).parent / "good_card.xml").read_text()
M = "<m>1.09</m>"
DENSITY = "<density>8930.0</density>"
EOS = '<equation_of_state type="mie_gruneisen">'
FLOW = '<plasticity_model type="johnson_cook">'
MODEL = '<constitutive_model type="hypoelastic_plastic">'


def test_the_card_itself_is_good(read_card):
    """The card that the other tests break is read."""
    assert read_card().material.flow.T_m == 1356.0


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
        (
            2,
            DENSITY,
            "<densty>8930</densty>",
            ("unknown tag <densty>", "did you mean 'density'?", "melt_temp"),
        ),
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
            ("'hyprelastic_plastic'", "did you mean 'hyperelastic_plastic'?"),
        ),
        (6, MODEL, MODEL.replace("type", "typ"), ("unknown attribute typ", "did you mean 'type'?")),
        (7, "<tolerance>1e-10", "<tolerance>0.5", ("out of its range", "<= 0.001")),
        (6, "<bulk_modulus>136.35e9</bulk_modulus>", "", ("lacks <bulk_modulus>",)),
        (9, "<shear_modulus>45", "<shear_modulus>-45", ("-45450000000.0 Pa",)),
        (
            10,
            FLOW,
            FLOW.replace("cook", "cok"),
            ("'johnson_cok'", "did you mean 'johnson_cook'?", "mts_model"),
        ),
        (10, M, "", ("lacks <m>", "add <m>")),
        (12, M, M.replace("m>", "mm>"), ("unknown tag <mm>", "did you mean 'm'?")),
        (12, M, M + "<T_m>200</T_m>", ("T_m = 200.0", "T_r = 294.0")),
        (17, EOS, EOS.replace("gruneisen", "grueneisen"), ("did you mean 'mie_gruneisen'?",)),
        (18, EOS, EOS + "<C_0>1</C_0>", ("given twice", "card.xml:17")),
        (20, "</constitutive_model>", "<damage_model type='none'/></constitutive_model>", ("given twice",)),
        (20, "</constitutive_model>", "</constitutive_model><damage_model type='none'/>", ("given twice",)),
        (20, "</constitutive_model>", "<flow_model type='none'/></constitutive_model>", ("given twice",)),
        (20, "</constitutive_model>", "<yield_condition/></constitutive_model>", ("has no type", "vonMises")),
        (22, "<radius>0.5", "<radius>-0.5", ("-0.5 m",)),
        (22, "[0,1,0]", "[0,0,0]", ("one point",)),
        (22, "[0,1,0]", "[0,1]", ("'[0,1]'", "write 3 numbers")),
        (22, "[0,1,0]", "0,1,0", ("write 3 numbers",)),
        (22, "[0,1,0]", "[0,1,nan]", ("'nan'",)),
        (22, 'label="c"', 'lable="c"', ("did you mean 'label'?",)),
        (23, "[0,-1,0]</velocity>", "[0,-1,0]</velocity><res>[1,1,1.5]</res>", ("whole numbers",)),
        (21, "<velocity>[0,-1,0]</velocity>", "", ("lacks <velocity>",)),
    ],
)
def test_bad_card_is_refused(refused, line, old, new, said):
    """Each bad input gives a one-line CardError: file, line, wrong value, remedy."""
    message = refused(CardError, line, (old, new))
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
    moduli = "<bulk_modulus>2</bulk_modulus><shear_modulus>1</shear_modulus>"
    card = f"<material><density>1</density>{MODEL}{moduli}</constitutive_model></material>"
    path = tmp_path / "card.xml"
    path.write_text(card)
    with pytest.raises(CardError, match=r"lacks <plasticity_model>; add one of type perfect, .*none"):
        read_material(path)
    path.write_text(card.replace(moduli, moduli + '<flow_model type="none"/>'))
    material = read_material(path).material
    assert material.flow is None
    assert material.yield_condition is None


def test_other_root_is_refused(tmp_path):
    """A whole deck or an included file is no material document."""
    path = tmp_path / "card.xml"
    path.write_text("<Uintah_specification/>")
    with pytest.raises(CardError, match=r"card\.xml:1: the root is <Uintah_specification>; .* <material>"):
        read_material(path)

"""Cards of the laws beyond the scalar radial return: in, out, and what they refuse."""

import pytest
from lxml import etree

from core_models.cards.reader import parse_material
from core_models.cards.writer import material_element
from core_models.errors import CardError, UnsupportedError
from core_models.kinematic_hardening.armstrong_frederick import ArmstrongFrederick
from core_models.kinematic_hardening.chaboche import Chaboche
from core_models.kinematic_hardening.prager import Prager
from core_models.kinematic_hardening.ziegler import Ziegler
from core_models.yield_condition.drucker_prager import DruckerPrager
from core_models.yield_condition.mohr_coulomb import MohrCoulomb

LAWS = {
    """<yield_condition type="drucker_prager"><alpha>0.2</alpha><beta>0.1</beta>
       </yield_condition>""": DruckerPrager(0.2, 0.1),
    """<yield_condition type="mohr_coulomb"><friction_angle>30</friction_angle><dilation_angle>10</dilation_angle>
       <tension_cutoff>1e5</tension_cutoff></yield_condition>""": MohrCoulomb(30.0, 10.0, 1e5),
    """<kinematic_hardening_model type="prager_hardening"><beta>1</beta><hardening_modulus>1e9</hardening_modulus>
       </kinematic_hardening_model>""": Prager(1e9),
    """<kinematic_hardening_model type="ziegler"><hardening_modulus>1e9</hardening_modulus>
       </kinematic_hardening_model>""": Ziegler(1e9),
    """<kinematic_hardening_model type="armstrong_frederick_hardening"><hardening_modulus_1>1e9</hardening_modulus_1>
       <hardening_modulus_2>100</hardening_modulus_2></kinematic_hardening_model>""": ArmstrongFrederick(1e9, 100.0),
    """<kinematic_hardening_model type="chaboche"><moduli>[1e9, 2e9]</moduli><recoveries>[10, 0]</recoveries>
       </kinematic_hardening_model>""": Chaboche((1e9, 2e9), (10.0, 0.0)),
}  # fmt: skip
FLOW = '<flow_model type="perfect"><sigma_Y>1e6</sigma_Y></flow_model>'
CARD = """<material><density>2000</density><constitutive_model type="hypoelastic_plastic">
<bulk_modulus>1e10</bulk_modulus><shear_modulus>6e9</shear_modulus>{}{}</constitutive_model></material>"""


def read(text):
    """The material of a card with a block."""
    return parse_material(etree.fromstring(CARD.format(FLOW, text)), "m").material


@pytest.mark.parametrize("text", LAWS)
def test_cards_say_the_law_and_are_written_back(text):
    """Each law is read from its tags, and what is written reads back equal."""
    material = read(text)
    assert LAWS[text] in material.laws
    assert parse_material(material_element(material), "m").material == material


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ("<beta>0.1", "<beta>0.3", "give beta <= alpha"),
        ("<dilation_angle>10", "<dilation_angle>40", "give dilation_angle <= friction_angle"),
        ("<friction_angle>30", "<friction_angle>90", "friction_angle"),
        ("[10, 0]", "[10, 0, 5]", "give one for each modulus"),
        ("<beta>1", "<beta>0.5", "partly isotropic"),
    ],
)
def test_numbers_that_make_no_sense_are_refused(old, new, told):
    """A card error says what to give instead."""
    text = next(text for text in LAWS if old in text)
    with pytest.raises((CardError, UnsupportedError), match=told):
        read(text.replace(old, new))

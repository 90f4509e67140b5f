"""Cards of the flow, melting, specific heat, damage and shear modulus laws: read as they are written elsewhere, refused
with a reason, written and read back.

Blocks marked so are those of the material files of Uintah (its repository at commit d4508b23, MIT licence).
"""

import pytest
from lxml import etree

from core_models.cards import material_element, parse_material, read_material, shipped_materials
from core_models.cards.models import read_law
from core_models.damage.hancock_mackenzie import HancockMackenzieDamage
from core_models.damage.sandia import SandiaDamage
from core_models.errors import CardError, MaterialError
from core_models.flow.anand import Anand
from core_models.flow.mts import MechanicalThreshold
from core_models.flow.preston_tonks_wallace import PrestonTonksWallace
from core_models.flow.steinberg_cochran_guinan import SteinbergCochranGuinan
from core_models.flow.tabulated import TabulatedHardening
from core_models.flow.thermal_voce import ThermalVoce
from core_models.flow.zerilli_armstrong import ZerilliArmstrong
from core_models.melting.constant import ConstantMelting
from core_models.melting.steinberg_cochran_guinan import SteinbergMelting
from core_models.schema import SLOTS
from core_models.shear_modulus.nadal_le_poac import NadalLePoac
from core_models.shear_modulus.preston_tonks_wallace import PrestonShearModulus
from core_models.shear_modulus.steinberg_cochran_guinan import SteinbergShearModulus
from core_models.shear_modulus.varshni import VarshniShearModulus
from core_models.specific_heat.constant import ConstantSpecificHeat
from core_models.specific_heat.copper import CopperSpecificHeat

GOOD_FLOW = (
    '<plasticity_model type="johnson_cook">\n'
    "<A>89.6e6</A> <B>292.0e6</B> <C>0.025</C> <n>0.31</n>\n"
    "<m>1.09</m>\n"
    "</plasticity_model>"
)
GOOD_DAMAGE = (
    '<damage_model type="johnson_cook">\n'
    "<D1>0.54</D1> <D2>4.89</D2> <D3>-3.03</D3> <D4>0.014</D4> <D5>1.12</D5>\n"
    "</damage_model>"
)
TOLERANCE = "<tolerance>1e-10</tolerance>"

# SCGPlasticETPCu.xml
STEINBERG = """<flow_model type="steinberg_cochran_guinan">
    <mu_0> 47.7e9 </mu_0> <sigma_0> 0.125e9 </sigma_0> <Y_max> 0.64e9 </Y_max> <beta> 36 </beta> <n> 0.45 </n>
    <A> 28.0e-12 </A> <B> 0.92e-3 </B> <T_m0> 1790.0 </T_m0> <Gamma_0> 1.99 </Gamma_0> <a> 1.5 </a>
    <epsilon_p0> 0.0 </epsilon_p0> </flow_model>"""
# adiCuSCG4000s696K.ups
LUND = STEINBERG.replace(
    "</flow_model>",
    """<C1> 0.71e6 </C1> <C2> 0.012e6 </C2> <energy_to_form_kink_pair> 0.31 </energy_to_form_kink_pair>
    <Boltzmann_constant> 8.617385e-5 </Boltzmann_constant> <Peierls_stress> 0.5e8 </Peierls_stress> </flow_model>""",
)
# adiCuZA4000s696K.ups
ZERILLI = """<flow_model type="zerilli_armstrong">
    <sigma_g> 46.5e6 </sigma_g> <k_H> 5.0e6 </k_H> <sqrt_l_inv> 3.7 </sqrt_l_inv> <B> 0.0 </B> <beta_0> 0.0 </beta_0>
    <beta_1> 0.0 </beta_1> <B_0> 890.0e6 </B_0> <alpha_0> 0.0028 </alpha_0> <alpha_1> 0.000115 </alpha_1> <K> 0.0 </K>
    <n> 0.0 </n> </flow_model>"""
# PTWPlasticTa.xml
PRESTON = """<flow_model type="preston_tonks_wallace">
    <theta> 0.02 </theta> <p> 0.0 </p> <s0> 0.012 </s0> <sinf> 0.00325 </sinf> <kappa> 0.6 </kappa>
    <gamma> 0.00004 </gamma> <y0> 0.01 </y0> <yinf> 0.00125 </yinf> <y1> 0.012 </y1> <y2> 0.4 </y2> <beta> 0.23 </beta>
    <M> 180.948 </M> <G0> 722e8 </G0> <alpha> 0.23 </alpha> <alphap> 0.48 </alphap> </flow_model>"""
# MTSPlasticHY100Steel.xml
THRESHOLD = """<flow_model type="mts_model">
    <sigma_a>40.0e6</sigma_a> <mu_0>71.46e9</mu_0> <D>2.9e9</D> <T_0>204</T_0> <koverbcubed>0.905e6</koverbcubed>
    <g_0i>1.161</g_0i> <g_0e>1.6</g_0e> <edot_0i>1.0e13</edot_0i> <edot_0e>1.0e7</edot_0e> <p_i>0.5</p_i> <q_i>1.5</q_i>
    <p_e>0.666667</p_e> <q_e>1.0</q_e> <sigma_i>1341.0e6</sigma_i> <a_0>6.0e9</a_0> <a_1>0.0</a_1> <a_2>0.0</a_2>
    <a_3>2.0758e6</a_3> <theta_IV>200.0e6</theta_IV> <alpha>3</alpha> <edot_es0>1.0e7</edot_es0> <g_0es>0.112</g_0es>
    <sigma_es0>822.0e6</sigma_es0> </flow_model>"""
ANAND = """<flow_model type="anand"> <s_0>56.33e6</s_0> <Q_over_R>10830</Q_over_R> <A>1.49e7</A> <xi>11</xi>
    <m>0.303</m> <h_0>2640.75e6</h_0> <s_hat>80.415e6</s_hat> <n>0.0231</n> <a>1.34</a> </flow_model>"""
VOCE = """<flow_model type="thermal_voce"> <sigma_0>0.45e9</sigma_0> <sigma_inf>0.715e9</sigma_inf> <delta>16.93</delta>
    <H>0.12924e9</H> <omega_0>0.002</omega_0> <omega_h>0.002</omega_h> </flow_model>"""
TABLE = """<flow_model type="tabulated"> <strains>[0, 0.1, 0.5]</strains> <stresses>[90e6, 230e6, 325e6]</stresses>
    </flow_model>"""

FLOWS = [
    (
        STEINBERG,
        SteinbergCochranGuinan(0.125e9, 36.0, 0.45, 0.0, 0.64e9, 28e-12, 0.92e-3, 1790.0, 1.99, 1.5),
    ),
    (
        LUND,
        SteinbergCochranGuinan(
            0.125e9, 36.0, 0.45, 0.0, 0.64e9, 28e-12, 0.92e-3, 1790.0, 1.99, 1.5, 0.71e6, 0.012e6, 0.31, 8.617385e-5,
            0.5e8,
        ),
    ),
    (ZERILLI, ZerilliArmstrong(46.5e6, 5e6, 3.7, 0.0, 0.0, 0.0, 890e6, 0.0028, 0.000115, 0.0, 0.0)),
    (
        PRESTON,
        PrestonTonksWallace(
            0.02, 0.0, 0.012, 0.00325, 0.6, 4e-5, 0.01, 0.00125, 0.012, 0.4, 0.23, 180.948, 72.2e9, 0.48, 0.0, 8930.0,
            1356.0,
        ),
    ),
    (
        THRESHOLD,
        MechanicalThreshold(
            40e6, 0.905e6, 1e7, 1.6, 1.0, 0.666667, 3.0, 1e7, 0.112, 822e6, 6e9, 0.0, 0.0, 2.0758e6, 200e6, 71.46e9,
            2.9e9, 204.0, 71.46e9, 1341e6, 1.161, 1e13, 0.5, 1.5,
        ),
    ),
    (ANAND, Anand(56.33e6, 10830.0, 1.49e7, 11.0, 0.303, 2640.75e6, 80.415e6, 0.0231, 1.34)),
    (VOCE, ThermalVoce(0.45e9, 0.715e9, 16.93, 0.12924e9, 0.002, 0.002, 294.0)),
    (TABLE, TabulatedHardening((0.0, 0.1, 0.5), (90e6, 230e6, 325e6))),
]  # fmt: skip


@pytest.mark.parametrize(
    ("block", "law"), FLOWS, ids=lambda x: type(x).__name__ if isinstance(x, tuple) else ""
)
def test_flow_law_is_read_and_comes_back(read_card, block, law):
    """The block gives every field of the law, the card around it what the block leaves out; written, it is the same."""
    material = read_card((GOOD_FLOW, block)).material
    assert material.flow == law
    assert parse_material(material_element(material)).material == material


def test_zerilli_armstrong_athermal_stress_has_two_names(read_card, refused):
    """c_0 alone is the whole athermal stress; beside sigma_g it is given twice."""
    grains = "<sigma_g> 46.5e6 </sigma_g> <k_H> 5.0e6 </k_H> <sqrt_l_inv> 3.7 </sqrt_l_inv>"
    flow = read_card((GOOD_FLOW, ZERILLI.replace(grains, "<c_0>65e6</c_0>"))).material.flow
    assert (flow.sigma_g, flow.k_H, flow.sqrt_l_inv) == (65e6, 0.0, 0.0)
    assert "given twice" in refused(
        CardError, 11, (GOOD_FLOW, ZERILLI.replace("<k_H>", "<c_0>65e6</c_0> <k_H>"))
    )


# SCGMaterials/SCG_CopperOFHC.xml: A in 1/Mbar
MEGABAR = STEINBERG.replace("28.0e-12", "2.83")
# SCGPlastic4340Steel.xml: Y_max = 0.25 GPa, below sigma_0 = 1.15 GPa
INVERTED = STEINBERG.replace("0.125e9", "1.15e9").replace("0.64e9", "0.25e9")


@pytest.mark.parametrize(
    ("block", "line", "said"),
    [
        (MEGABAR, 12, ("<A> is 2.83 1/Pa", "<= 1e-09 1/Pa")),
        (
            INVERTED,
            11,
            ("Y_max = 250000000.0 is not above sigma_0 = 1150000000.0", "give Y_max above sigma_0"),
        ),
        (
            LUND.replace("<C2> 0.012e6 </C2>", ""),
            10,
            ("Peierls_stress needs C1, C2", "give these, or none of the four"),
        ),
        (STEINBERG.replace("28.0e-12", "1.3-11"), 12, ("'1.3-11'", "did you mean 1.3e-11?")),
        (PRESTON.replace("<M> 180.948 </M>", ""), 10, ("lacks <M>",)),
        (PRESTON.replace("<p> 0.0", "<p> -1.0"), 11, ("<p> is -1.0", "give a value >= 0")),
        (ANAND.replace("1.34", "0.9"), 11, ("<a> is 0.9", "give a value >= 1")),
        (
            TABLE.replace("0.5]", "0.5, 1]"),
            10,
            ("4 strains and 3 stresses", "give one stress for each strain"),
        ),
        (TABLE.replace("0.1, 0.5", "0.5, 0.1"), 10, ("must begin with 0 and rise", "sort them")),
        (TABLE.replace("[0, 0.1", "[0.01, 0.1"), 10, ("must begin with 0 and rise",)),
        (TABLE.replace("[0, 0.1, 0.5]", "[0]"), 10, ("write two or more numbers like [0.0, 1.0, 0.0]",)),
        (TABLE.replace("90e6", "-90e6"), 10, ("<stresses> is -90000000.0 Pa", "give a value > 0")),
    ],
)
def test_bad_flow_law_is_refused_with_its_reason(refused, block, line, said):
    """Units slipped, limits crossed, halves of a term, tables out of order: line, number and remedy."""
    message = refused(CardError, line, (GOOD_FLOW, block))
    for words in said:
        assert words in message


@pytest.mark.parametrize(
    ("block", "law"),
    [
        (
            '<damage_model type="hancock_mackenzie"> <initial_mean_scalar_damage>0.0001</initial_mean_scalar_damage>'
            "<critical_scalar_damage>0.7</critical_scalar_damage> </damage_model>",
            HancockMackenzieDamage(1e-4, 0.7),
        ),
        ('<damage_model type="hancock_mackenzie"/>', HancockMackenzieDamage(0.0, 1.0)),
        (
            '<damage_model type="cocks_ashby"> <m>4</m> <initial_mean_porosity>0.002</initial_mean_porosity>'
            "<critical_porosity>0.2</critical_porosity> </damage_model>",
            SandiaDamage(4.0, 0.002, 0.2),
        ),
    ],
)
def test_damage_law_is_read_and_comes_back(read_card, block, law):
    """Damage with its initial and critical values, or their defaults."""
    material = read_card((GOOD_DAMAGE, block)).material
    assert material.damage == law
    assert parse_material(material_element(material)).material == material


# JCDamETPCu.xml and HancockDamETPCu.xml, whose outer tag is commented out
@pytest.mark.parametrize(
    ("lost", "home"),
    [
        ("<D1>0.54</D1> <D2>4.89</D2>", '<damage_model type="johnson_cook">'),
        ("<critical_scalar_damage>0.7</critical_scalar_damage>", '<damage_model type="hancock_mackenzie">'),
    ],
)
def test_tag_outside_its_block_is_sent_home(refused, lost, home):
    """A fragment that lost its outer tag is told which one it is."""
    assert f"it belongs into a {home}" in refused(CardError, 7, (TOLERANCE, TOLERANCE + lost))


def test_damage_that_has_failed_at_the_start_is_refused(refused):
    """The critical value lies above the initial one."""
    block = (
        '<damage_model type="sandia"> <m>4</m> <initial_porosity>0.3</initial_porosity>\n'
        "<critical_porosity>0.2</critical_porosity> </damage_model>"
    )
    assert "give critical_porosity above initial_porosity" in refused(CardError, 15, (GOOD_DAMAGE, block))


def test_melting_and_specific_heat_of_a_block_go_before_the_constants(read_card):
    """The constants still serve the laws that take T_m from melt_temp; plain types leave the constants in force."""
    blocks = (
        '<melting_temp_model type="scg_Tm"><T_m0>1790</T_m0><Gamma_0>1.99</Gamma_0><a>1.5</a></melting_temp_model>'
        '<specific_heat_model type="copper_Cp"/>'
    )
    material = read_card((TOLERANCE, TOLERANCE + blocks)).material
    assert (material.melting, material.specific_heat) == (
        SteinbergMelting(1790.0, 1.99, 1.5),
        CopperSpecificHeat(),
    )
    assert material.flow.T_m == 1356.0
    assert parse_material(material_element(material)).material == material
    plain = '<melting_temp_model type="constant_Tm"/><specific_heat_model type="constant_Cp"/>'
    material = read_card((TOLERANCE, TOLERANCE + plain)).material
    assert (material.melting, material.specific_heat) == (
        ConstantMelting(1356.0),
        ConstantSpecificHeat(383.0),
    )


def test_melting_below_0_kelvin_is_refused(refused):
    """alpha^2 must exceed 4 b^2 rho(T_m)."""
    block = (
        '<melting_temp_model type="bps_Tm"><B0>166e9</B0><dB_dp0>5.29</dB_dp0><G0>81.9e9</G0><dG_dp0>1.8</dG_dp0>'
        "<z>8</z><b2rhoTm>0.78</b2rhoTm><alpha>1.5</alpha><lambda>1.3</lambda><a>2.87e-10</a>"
        "<v_ws_a3_factor>0.5</v_ws_a3_factor></melting_temp_model>"
    )
    assert "nothing melts above 0 K" in refused(CardError, 7, (TOLERANCE, block))


SHEAR_MODULUS = next(slot for slot in SLOTS if slot.slot == "shear_modulus")


@pytest.mark.parametrize(
    ("block", "law"),
    [
        (
            '<shear_modulus_model type="mts_shear"><mu_0>47.7e9</mu_0><D>3.0e9</D><T_0>180</T_0></shear_modulus_model>',
            VarshniShearModulus(47.7e9, 3e9, 180.0),
        ),
        (
            '<shear_modulus_model type="scg_shear"><mu_0>47.7e9</mu_0><A>28e-12</A><B>3.8e-4</B></shear_modulus_model>',
            SteinbergShearModulus(47.7e9, 28e-12, 3.8e-4),
        ),
        (
            '<shear_modulus_model type="ptw_shear"><mu_0>722e8</mu_0><alpha>0.23</alpha><alphap>0.48</alphap>'
            "<slope_mu_p_over_mu0>14.5e-12</slope_mu_p_over_mu0></shear_modulus_model>",
            PrestonShearModulus(72.2e9, 0.48, 14.5e-12),
        ),
        (
            '<shear_modulus_model type="np_shear"><mu_0>50.7e9</mu_0><slope_mu_p_over_mu0>28e-12</slope_mu_p_over_mu0>'
            "<zeta>0.04</zeta><C>0.057</C><m>63.55</m></shear_modulus_model>",
            NadalLePoac(50.7e9, 0.04, 28e-12, 0.057, 63.55, 8930.0),
        ),
    ],
)
def test_shear_modulus_law_is_read(block, law):
    """Every block gives its law; the density is that of the card."""
    assert read_law(etree.fromstring(block), SHEAR_MODULUS, {"density": 8930.0}) == law


def test_law_with_a_fault_cannot_be_written(read_card):
    """What the reader would refuse is not written."""
    material = read_card((GOOD_FLOW, TABLE)).material
    object.__setattr__(material, "flow", TabulatedHardening((0.0, 0.2, 0.1), (1e8, 2e8, 3e8)))
    with pytest.raises(MaterialError, match="must begin with 0 and rise"):
        material_element(material)


# SCG_Tantalum.xml, with moduli and without its comments; it prints A in 1/Mbar under the heading 1/Pa
TANTALUM = """<material name="tantalum"><density> 16690.0 </density> <thermal_conductivity> 57.5 </thermal_conductivity>
<specific_heat> 135.0 </specific_heat> <room_temp> 298.0 </room_temp> <melt_temp> 4340.0 </melt_temp>
<constitutive_model type="elastic_plastic"> <bulk_modulus>194e9</bulk_modulus><shear_modulus>69e9</shear_modulus>
<flow_model type="steinberg_cochran_guinan"> <mu_0> 69.0e9 </mu_0> <sigma_0> 0.77e9 </sigma_0> <Y_max> 1.10e9 </Y_max>
<beta> 22 </beta> <n> 0.283 </n> <A> 1.45 </A> <B> 1.30e-4 </B> <T_m0> 4340.0 </T_m0> <Gamma_0> 1.67 </Gamma_0>
<a> 1.3 </a> <epsilon_p0> 0.0 </epsilon_p0> </flow_model>
<shear_modulus_model type="scg_shear"> <mu_0> 69.0e9 </mu_0> <A> 1.45 </A> <B> 1.30e-4 </B> </shear_modulus_model>
<melting_temp_model type="scg_Tm"> <T_m0> 4340.0 </T_m0> <Gamma_0> 1.67 </Gamma_0> <a> 1.3 </a> </melting_temp_model>
<equation_of_state type="mie_gruneisen"> <C_0> 3410.0 </C_0> <Gamma_0> 1.67 </Gamma_0> <S_alpha> 1.20 </S_alpha>
<S_2> 0.0 </S_2> <S_3> 0.0 </S_3> </equation_of_state>
<initial_material_temperature> 298.0 </initial_material_temperature> </constitutive_model></material>"""


def test_a_whole_material_of_the_other_code_is_read_and_its_unit_slip_refused():
    """With A in 1/Pa it is the tantalum that ships, but for heating; as printed it is refused with the factor."""
    shipped = read_material(shipped_materials()["tantalum_steinberg_cochran_guinan"]).material
    read = parse_material(etree.fromstring(TANTALUM.replace("<A> 1.45 </A>", "<A> 1.45e-11 </A>"))).material
    for slot in ("flow", "shear_modulus", "melting", "yield_condition", "heating"):
        assert getattr(read, slot) == getattr(shipped, slot)
    with pytest.raises(
        CardError, match=r"<A> is 1.45 1/Pa, out of its range; give a value >= 0 and <= 1e-09"
    ):
        parse_material(etree.fromstring(TANTALUM))


def test_fragments_that_lost_their_block_are_told_where_they_belong():
    """JohnsonCookDamageAnnCopper.xml and HancockDamETPCu.xml hold bare tags: the message names the block."""
    for tag, block in (("D1", "johnson_cook"), ("initial_mean_scalar_damage", "hancock_mackenzie")):
        card = etree.fromstring(TANTALUM.replace("<density>", f"<{tag}>0.54</{tag}><density>", 1))
        with pytest.raises(CardError, match=f'it belongs into a <damage_model type="{block}">'):
            parse_material(card)

"""The materials that come with matpoint: which there are, what was corrected in them, what they are at the start."""

import re

import pytest

from core_models.cards import material_element, parse_material, read_material, shipped_materials
from core_models.flow.steinberg_cochran_guinan import SteinbergCochranGuinan
from core_models.laws import elastic_moduli, flow_stress

NAMES = {
    "aluminium_6061_t6_johnson_cook",
    "concrete_c30_drucker_prager",
    "copper_etp_mts",
    "copper_hyperelastic_mts",
    "copper_hypoelastic_johnson_cook",
    "copper_ofhc_johnson_cook",
    "copper_ofhc_preston_tonks_wallace",
    "copper_ofhc_steinberg_cochran_guinan",
    "copper_ofhc_zerilli_armstrong",
    "iron_armco_johnson_cook",
    "sand_dense_mohr_coulomb",
    "solder_60sn40pb_anand",
    "steel_42crmo4_johnson_cook",
    "steel_4340_johnson_cook",
    "steel_hy100_johnson_cook",
    "steel_hy100_mts",
    "steel_weldox_460e_johnson_cook",
    "tantalum_steinberg_cochran_guinan",
    "tungsten_johnson_cook",
    "tungsten_steinberg_cochran_guinan",
}
FOUNDING = {"copper_hyperelastic_mts", "copper_hypoelastic_johnson_cook"}  # kept as their document has them
SOURCE = re.compile(
    r"Uintah|DynELA|Karamelo|J\. Appl\. Phys\.|J\. Electron\. Packag\.|EN 199|Bowles|The same|Chosen here"
)


def material(name):
    """A shipped material."""
    return read_material(shipped_materials()[name]).material


def test_metals_are_there():
    """Copper, 4340, HY100, 42CrMo4, Weldox steel, Armco iron, 6061-T6, tantalum, tungsten, solder, sand, concrete."""
    assert set(shipped_materials()) >= NAMES


@pytest.mark.parametrize("name", sorted(NAMES - FOUNDING))
def test_every_block_says_where_its_numbers_come_from(name):
    """A comment with a source stands before the first number and before each model."""
    text = shipped_materials()[name].read_text(encoding="utf-8")
    body = text[text.index("<material") :]
    for tag in ("<density>", "<shear_modulus>", "<plasticity_model", "<damage_model", "<equation_of_state"):
        if tag in body:
            comment = body[: body.index(tag)].rsplit("<!--", 1)[1]
            assert SOURCE.search(comment), tag


def test_known_misprints_are_corrected_and_noted():
    """Armco iron's m, Steinberg's A in 1/Mbar, copper's B, tantalum's malformed number, HY100's reference rate."""
    iron = shipped_materials()["iron_armco_johnson_cook"].read_text(encoding="utf-8")
    assert material("iron_armco_johnson_cook").flow.m == 0.55
    assert "misprint" in iron
    for name, slope in (("copper_ofhc", 2.83e-11), ("tantalum", 1.45e-11), ("tungsten", 0.938e-11)):
        path = shipped_materials()[f"{name}_steinberg_cochran_guinan"]
        printed = read_material(path).material.flow.A
        assert printed == slope
        assert "1/Mbar under the heading 1/Pa" in path.read_text(encoding="utf-8")
    assert material("copper_ofhc_steinberg_cochran_guinan").flow.B == 3.77e-4
    assert material("tantalum_steinberg_cochran_guinan").flow.beta == 22.0
    assert material("steel_hy100_johnson_cook").flow.epdot_0 == 3300.0
    assert material("copper_ofhc_johnson_cook").flow.C == 0.025


@pytest.mark.parametrize(
    ("name", "young", "poisson"),
    [("steel_42crmo4_johnson_cook", 206.9e9, 0.3), ("steel_weldox_460e_johnson_cook", 211e9, 0.33)],
)
def test_moduli_are_those_of_young_and_poisson(name, young, poisson):
    """K and G of the card give back E and nu of its source."""
    bulk, shear = elastic_moduli(material(name).elasticity)
    assert 9.0 * bulk * shear / (3.0 * bulk + shear) == pytest.approx(young, rel=1e-12)
    assert (3.0 * bulk - 2.0 * shear) / (6.0 * bulk + 2.0 * shear) == pytest.approx(poisson, rel=1e-12)


@pytest.mark.parametrize(
    ("name", "strength"),
    [
        ("steel_4340_johnson_cook", 792e6),
        ("aluminium_6061_t6_johnson_cook", 324e6),
        ("steel_weldox_460e_johnson_cook", 499e6),
        ("copper_ofhc_zerilli_armstrong", 65e6),
        ("tantalum_steinberg_cochran_guinan", 0.77e9 * (1.0 + 2.0 * 1.30e-4)),
    ],
)
def test_initial_strength(name, strength):
    """What the card's material yields at, at room temperature and without strain."""
    metal = material(name)
    assert flow_stress(metal.flow, 0.0, 0.0, 0.0, metal.room_temperature)[0] == pytest.approx(
        strength, rel=1e-9
    )


def test_negative_failure_strain_is_told(caplog):
    """6061-T6 aluminium, above a triaxiality of 1.347, and no other of the metals."""
    for name in NAMES:
        material(name)
    assert [record.levelname for record in caplog.records] == ["WARNING"]
    assert "aluminium_6061_t6_johnson_cook.xml" in caplog.text
    assert "the failure strain turns negative above a triaxiality of 1.347: there it is 0.001" in caplog.text


def test_weldox_is_isothermal():
    """Without a specific heat nothing is heated, and the idle softening stays idle."""
    assert material("steel_weldox_460e_johnson_cook").heating is None


def test_steinberg_cards_harden_to_their_limit():
    """The limit lies above the initial strength, below the modulus."""
    for name in NAMES:
        flow = material(name).flow
        if isinstance(flow, SteinbergCochranGuinan):
            assert flow.sigma_0 < flow.Y_max < 0.05 * elastic_moduli(material(name).elasticity)[1]


def test_concrete_has_its_uniaxial_strengths():
    """The Drucker-Prager cone goes through compression at 38 MPa and tension at 2.9 MPa."""
    concrete = material("concrete_c30_drucker_prager")
    alpha, k = concrete.yield_condition.alpha, concrete.flow.yield_stress
    for stress in (-38e6, 2.9e6):
        assert abs(stress) / 3.0**0.5 + alpha * stress == pytest.approx(k, rel=1e-5)


def test_every_shipped_card_is_written_and_read_back():
    """Defaults that no decimal number can say, such as no tension cut-off, included."""
    for name in NAMES:
        assert parse_material(material_element(material(name))).material == material(name)

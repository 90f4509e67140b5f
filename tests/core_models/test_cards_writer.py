"""A Material goes out and comes back equal."""

import os
from typing import NamedTuple

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from lxml import etree

from core_models.cards import (
    material_element,
    parse_material,
    read_material,
    shipped_materials,
    write_material,
)
from core_models.compatibility import WHOLE_UPDATES
from core_models.elasticity.isotropic import IsotropicElastic
from core_models.eos.mie_gruneisen import MieGruneisen
from core_models.eos.neo_hookean import NeoHookean
from core_models.errors import CardError, MaterialError, OutputError
from core_models.flow.johnson_cook import JohnsonCook
from core_models.flow.linear import LinearHardening
from core_models.flow.tabulated import TabulatedHardening
from core_models.material import Material
from core_models.melting.constant import ConstantMelting
from core_models.schema import SLOTS
from core_models.specific_heat.constant import ConstantSpecificHeat
from core_models.updates.compressible_neo_hookean import CompressibleNeoHookean
from core_models.updates.hyperelastic_plastic import HyperelasticPlastic
from core_models.yield_condition.von_mises import VonMises


def steel(**changes):
    """A material, with changes."""
    fields = {
        "name": "steel",
        "density": 7830.0,
        "update": HyperelasticPlastic(),
        "elasticity": IsotropicElastic(164e9, 80e9),
        "eos": NeoHookean(164e9),
        "flow": LinearHardening(0.45e9, 0.13e9),
        "yield_condition": VonMises(),
    }
    return Material(**fields | changes)


@pytest.mark.parametrize("name", shipped_materials())
def test_shipped_material_comes_back_equal(name, tmp_path):
    """Every shipped card is written to a card that needs no other file and reads back equal."""
    material = read_material(shipped_materials()[name]).material
    write_material(material, tmp_path / "other.xml")
    assert read_material(tmp_path / "other.xml").material == material
    assert "include" not in (tmp_path / "other.xml").read_text()


LIMITS = {
    "T_r": (0.0, 300.0),
    "T_m": (400.0, 900.0),
    "sigma_0": (0.0, 300.0),
    "Y_max": (400.0, 1e3),
    "initial_mean_scalar_damage": (0.0, 0.3),
    "critical_scalar_damage": (0.4, 1e3),
    "initial_porosity": (0.0, 0.3),
    "critical_porosity": (0.4, 1.0),
    "T_m0": (900.0, 4e3),
}
"""Ranges in which numbers that depend on each other are drawn."""


def numbers(parameter):
    """Numbers of a parameter's range, such that a Material accepts most of them together."""
    low, high, low_open, high_open = parameter.range
    bottom, top = LIMITS.get(parameter.tag, (-1e3, 1e3))
    one = st.floats(
        max(low, bottom),
        min(high, top),
        exclude_min=low_open and low >= bottom,
        exclude_max=high_open and high <= top,
        allow_subnormal=False,
    )
    return one if parameter.size == 1 else st.tuples(*[one] * parameter.size)


@st.composite
def tables(draw):
    """Tables of flow stress over strain."""
    strains = sorted(draw(st.sets(st.floats(1e-6, 10.0), min_size=1, max_size=5)))
    stresses = draw(st.lists(st.floats(1.0, 1e3), min_size=len(strains) + 1, max_size=len(strains) + 1))
    return TabulatedHardening((0.0, *strains), tuple(stresses))


def built(model):
    """Laws of a model."""
    if model.law is TabulatedHardening:
        return tables()
    return st.builds(model.law, **{p.field: numbers(p) for p in model.parameters})


def laws(slot):
    """Laws of a slot that go with an equation of state."""
    models = [m for s in SLOTS if s.slot == slot for m in s.models if m.law not in WHOLE_UPDATES]
    return st.one_of(*(built(model) for model in models)).filter(lambda law: not getattr(law, "fault", str)())


@st.composite
def materials(draw):
    """The fields of materials that make sense more often than not."""
    flow = draw(st.none() | laws("flow"))
    density = draw(st.floats(1.0, 1e5))
    bulk_modulus = draw(st.floats(1e8, 1e12))
    eos = draw(laws("eos"))
    if isinstance(eos, MieGruneisen):
        eos = eos._replace(reference_density=density, C_0=(bulk_modulus / density) ** 0.5)
    constant_heat = st.builds(ConstantSpecificHeat, st.floats(1.0, 1e4))
    specific_heat = draw(st.none() | constant_heat | laws("specific_heat"))
    damage = None if flow is None else draw(st.none() | laws("damage"))
    return {
        "name": draw(st.text(st.characters(codec="utf-8", exclude_categories=["C"]), min_size=1, max_size=8)),
        "density": density,
        "update": draw(laws("update")),
        "elasticity": IsotropicElastic(bulk_modulus, draw(st.floats(1e8, 1e12))),
        "eos": eos,
        "flow": flow,
        "yield_condition": None if flow is None else VonMises(),
        "damage": damage,
        "erosion": None if damage is None else draw(st.none() | laws("erosion")),
        "melting": draw(st.none() | st.builds(ConstantMelting, st.floats(900.0, 4e3)) | laws("melting")),
        "specific_heat": specific_heat,
        "heating": None if flow is None or specific_heat is None else draw(st.none() | laws("heating")),
        "room_temperature": draw(st.floats(1.0, 800.0)),
        "thermal_conductivity": draw(st.none() | st.floats(1e-3, 1e3)),
    }


@settings(max_examples=100, deadline=None)
@given(materials())
def test_any_material_comes_back_equal(fields):
    """Whatever laws and numbers a Material accepts, the card gives them back exactly."""
    try:
        material = Material(**fields)
    except (MaterialError, ArithmeticError):
        assume(False)
    assert parse_material(material_element(material)).material == material


@pytest.mark.parametrize("heating", [True, False])
def test_heating_that_was_switched_off_stays_off(heating):
    """An effect left out in Python is not brought back by the card's defaults."""
    copper = read_material(shipped_materials()["copper_ofhc_johnson_cook"]).material
    fields = {f: getattr(copper, f) for f in copper.__dataclass_fields__}
    material = Material(**fields | {"heating": copper.heating if heating else None})
    assert parse_material(material_element(material)).material == material


def test_own_temperatures_of_a_law_survive():
    """T_r and T_m that differ from the card's are stated in the law's block."""
    material = steel(
        flow=JohnsonCook(792e6, 510e6, 0.014, 0.26, 1.03, 1.0, 298.0, 1793.0),
        eos=MieGruneisen(7830.0, 3574.0, 1.69, 1.92),
        elasticity=IsotropicElastic(100.1e9, 80e9),
    )
    assert parse_material(material_element(material)).material == material


def test_elastic_material_survives():
    """A material without flow is written as such."""
    material = steel(flow=None, yield_condition=None)
    assert parse_material(material_element(material)).material == material


def test_neo_hookean_material_survives():
    """A material whose stress needs no other law is written without them, and its card takes no tolerance."""
    material = Material("rubber", 1000.0, CompressibleNeoHookean(), IsotropicElastic.from_young(1e7, 0.0))
    element = material_element(material)
    assert parse_material(element).material == material
    etree.SubElement(element.find("constitutive_model"), "tolerance").text = "1e-10"
    with pytest.raises(CardError, match="tolerance"):
        parse_material(element)


@pytest.mark.parametrize(
    "changes",
    [{"name": "a\0b"}, {"name": ""}, {"density": float("inf")}],
)
def test_material_that_no_card_can_say_is_refused_and_nothing_is_written(changes, tmp_path):
    """What could not be read back is never written."""
    with pytest.raises(MaterialError, match="cannot be written as a card"):
        write_material(steel(**changes), tmp_path / "card.xml")
    assert os.listdir(tmp_path) == []


class Unheard(NamedTuple):
    """A law that no schema knows."""

    yield_stress: float


def test_law_without_a_schema_is_named():
    """A user's own law has no tag in the cards, and the error says so."""
    material = steel()
    object.__setattr__(material, "flow", Unheard(1e8))
    with pytest.raises(MaterialError, match="Unheard has no card schema"):
        material_element(material)


def test_writing_is_all_or_nothing(tmp_path, monkeypatch):
    """A failed write leaves the old file as it was and no other file beside it."""
    path = tmp_path / "card.xml"
    path.write_bytes(b"old")

    def broken(*_):
        raise OSError("disk full")

    monkeypatch.setattr(os, "fsync", broken)
    with pytest.raises(OutputError, match="disk full"):
        write_material(steel(), path)
    assert path.read_bytes() == b"old"
    assert os.listdir(tmp_path) == ["card.xml"]


def test_missing_folder_is_an_output_error(tmp_path):
    """A folder that is not there is named, with the remedy."""
    with pytest.raises(OutputError, match="writable folder"):
        write_material(steel(), tmp_path / "nowhere" / "card.xml")

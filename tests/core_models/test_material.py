"""Materials that make no sense are refused when they are made; so are laws in a wrong slot or with a taken name."""

from dataclasses import replace
from typing import NamedTuple

import pytest

from core_models.damage.johnson_cook import JohnsonCookDamage
from core_models.elasticity.isotropic import IsotropicElastic
from core_models.eos.default_hypo import DefaultHypoelastic
from core_models.eos.mie_gruneisen import MieGruneisen
from core_models.erosion.zero_stress import ZeroStress
from core_models.errors import MaterialError
from core_models.flow.johnson_cook import JohnsonCook
from core_models.flow.perfect import PerfectPlasticity as Perfect
from core_models.heating.taylor_quinney import TaylorQuinney
from core_models.laws import flow_stress
from core_models.melting.constant import ConstantMelting
from core_models.specific_heat.constant import ConstantSpecificHeat
from core_models.updates.compressible_neo_hookean import CompressibleNeoHookean
from core_models.yield_condition.von_mises import VonMises

DAMAGE = JohnsonCookDamage(0.54, 4.89, -3.03, 0.014, 1.12, 294.0, 1356.0)
HOT_FLOW = JohnsonCook(89.6e6, 292e6, 0.025, 0.31, 1.09, 1.0, 294.0, 1356.0)

SENSELESS = {
    "no density": ({"density": 0.0}, "density must be positive"),
    "density that is no number": ({"density": float("nan")}, "density must be positive"),
    "negative modulus": ({"elasticity": IsotropicElastic(-1e9, 45e9)}, "bulk_modulus = -1000000000.0 Pa"),
    "no shear modulus": ({"elasticity": IsotropicElastic(136e9, 0.0)}, "shear_modulus = 0.0 Pa"),
    "hyperelastic without stored energy": (
        {"eos": DefaultHypoelastic(136e9)},
        "take neo_hookean or mie_gruneisen",
    ),
    "flow without yield condition": ({"yield_condition": None}, "give both"),
    "yield condition without flow": ({"flow": None}, "give both"),
    "two densities": ({"eos": MieGruneisen(8000.0, 3940.0, 2.02, 1.489)}, "reference density 8000.0"),
    "two bulk moduli": ({"eos": MieGruneisen(8930.0, 2000.0, 2.02, 1.489)}, "correct one of them"),
    "heating without heat capacity": ({"heating": TaylorQuinney(0.9)}, "add specific_heat"),
    "heating without plasticity": (
        {
            "heating": TaylorQuinney(0.9),
            "specific_heat": ConstantSpecificHeat(383.0),
            "flow": None,
            "yield_condition": None,
        },
        "needs a flow law",
    ),
    "damage without plasticity": (
        {"damage": DAMAGE, "flow": None, "yield_condition": None},
        "add a flow law",
    ),
    "erosion without damage": ({"erosion": ZeroStress()}, "add a damage law"),
    "melting below room temperature": ({"melting": ConstantMelting(250.0)}, "must lie above room_temp"),
    "flow law that melts before it softens": ({"flow": HOT_FLOW._replace(T_m=200.0)}, "is not above T_r"),
    "damage law that melts before it softens": ({"damage": DAMAGE._replace(T_m=294.0)}, "is not above T_r"),
    "strength beyond melting": ({"flow": HOT_FLOW, "melting": ConstantMelting(1000.0)}, "melt first"),
    "strength above the shear modulus": (
        {"flow": Perfect(50e9)},
        "between 0 and the shear modulus",
    ),
    "negative strength": ({"flow": Perfect(-1e6)}, "yield_stress = -1000000.0 Pa is out of its range"),
    "no equation of state": ({"eos": None}, "needs a law in the slot eos"),
    "no elasticity": ({"elasticity": None}, "needs a law in the slot elasticity"),
    "update that is none": ({"update": VonMises()}, "is no law for the slot update: use one of"),
    "no update": ({"update": None}, "needs a law in the slot update"),
    "no conductivity": ({"thermal_conductivity": 0.0}, "thermal_conductivity must be positive, not 0.0"),
    "plastic neo-Hookean solid": ({"update": CompressibleNeoHookean(), "eos": None}, "leave flow out"),
    "neo-Hookean solid with an equation of state": (
        {"update": CompressibleNeoHookean(), "flow": None, "yield_condition": None},
        "leave eos out",
    ),
}


@pytest.mark.parametrize(("changes", "remedy"), SENSELESS.values(), ids=list(SENSELESS))
def test_senseless_combinations_are_refused_with_a_remedy(copper, changes, remedy):
    """One line that names the material and says what to do."""
    with pytest.raises(MaterialError) as refusal:
        replace(copper("hyper", "linear"), name="odd copper", **changes)
    message = str(refusal.value)
    assert message.startswith("odd copper: ")
    assert remedy in message
    assert "\n" not in message


@pytest.mark.parametrize(
    ("slot", "law"),
    [
        ("flow", VonMises()),
        ("yield_condition", Perfect(1e8)),
        ("eos", IsotropicElastic(136e9, 45e9)),
        ("elasticity", DefaultHypoelastic(136e9)),
        ("damage", ZeroStress()),
        ("melting", ConstantSpecificHeat(383.0)),
        ("flow", 4e8),
    ],
)
def test_a_law_in_the_wrong_slot_is_refused(copper, slot, law):
    """The message names the slot and the laws that belong there."""
    with pytest.raises(MaterialError, match=rf"is no law for the slot {slot}: use one of \w+"):
        replace(copper("hyper", "linear"), **{slot: law})


def test_two_laws_of_one_name_are_refused():
    """The compiler tells laws apart by name: a second class of a known name may not register."""

    class PerfectPlasticity(NamedTuple):
        yield_stress: float

    with pytest.raises(
        MaterialError, match="PerfectPlasticity exists already in core_models.flow.perfect: rename"
    ):
        flow_stress.register(PerfectPlasticity)


def test_a_call_for_an_unknown_law_names_the_known_ones():
    """Plain Python calls of a generic function say which laws it knows."""
    with pytest.raises(MaterialError, match="flow_stress is not defined for VonMises: .*PerfectPlasticity"):
        flow_stress(VonMises(), 0.0, 0.0, 0.0, 294.0)


@pytest.mark.parametrize("temperature", [0.0, 0.1, 5.0, 3000.0])
@pytest.mark.parametrize("b3", [180.0, 1e5, 1e-3])
def test_a_threshold_law_can_be_made_for_any_room_temperature(copper, flow_laws, temperature, b3):
    """At extreme temperatures the modulus of the threshold law neither overflows nor divides by zero."""
    material = copper("hyper", flow_laws["mts"]._replace(b3=b3), room_temperature=temperature)
    assert material.needs_temperature


def test_materials_are_equal_when_their_laws_are(copper):
    """Two materials made alike are equal; another parameter makes another material."""
    assert copper("hyper", "jc") == copper("hyper", "jc")
    assert copper("hyper", "jc") != copper("hyper", HOT_FLOW._replace(C=0.0))


def test_effects_are_listed_with_reasons(copper, hot_copper):
    """Every effect says whether it is simulated and why, the absent ones as well."""
    full = {effect.name: effect for effect in hot_copper("hypo", "jc").effects()}
    bare = {effect.name: effect for effect in copper("hypo").effects()}
    assert full.keys() == bare.keys()
    assert {name for name, effect in full.items() if not effect.on} == {
        "erosion",
        "kinematic hardening",
        "variable shear modulus",
        "strength under pressure",
        "loss of stability",
        "heat of volume change",
        "thermal expansion",
    }
    assert not any(effect.on for effect in bare.values())
    assert all(effect.reason for effect in (*full.values(), *bare.values()))

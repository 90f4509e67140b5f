"""Numbers that make no law: refused, or told, the same in a material made in Python as in a card."""

import logging
import math
import re
from dataclasses import replace
from typing import NamedTuple

import numpy as np
import pytest

from core_models.cards import read_material, shipped_materials
from core_models.damage.gurson import VoidNucleation
from core_models.damage.hancock_mackenzie import HancockMackenzieDamage
from core_models.damage.johnson_cook import JohnsonCookDamage
from core_models.errors import CardError, MaterialError, SceneError
from core_models.flow.linear import LinearHardening
from core_models.flow.mts import MechanicalThreshold
from core_models.flow.preston_tonks_wallace import PrestonTonksWallace
from core_models.flow.steinberg_cochran_guinan import SteinbergCochranGuinan
from core_models.flow.tabulated import TabulatedHardening
from core_models.flow.voce import Voce
from core_models.laws import flow_stress
from core_models.melting.burakovsky_preston_silbar import BurakovskyMelting
from core_models.points import MaterialPoints
from core_models.shear_modulus.varshni import VarshniShearModulus
from core_models.specific_heat.constant import ConstantSpecificHeat
from core_models.yield_condition.drucker_prager import DruckerPrager
from core_models.yield_condition.gurson import Gurson

STEINBERG = SteinbergCochranGuinan(0.12e9, 36.0, 0.45, 0.0, 0.64e9, 2.83e-11, 3.77e-4, 1790.0, 2.02, 1.5)
PRESTON = PrestonTonksWallace(
    0.02, 0.0, 0.012, 0.00325, 0.6, 4e-5, 0.01, 0.00125, 0.012, 0.4, 0.23, 180.948, 45.4e9, 0.2, 14.5e-12, 8930.0,
    1356.0,
)  # fmt: skip
THRESHOLD = MechanicalThreshold(
    40e6, 0.823e6, 1e7, 1.6, 1.0, 2 / 3, 2.0, 1e7, 0.2625, 770e6, 2390e6, 12e6, 1.696e6, 0.0, 0.0, 47.7e9, 3e9, 180.0,
    47.7e9,
)  # fmt: skip
FLOW = '<plasticity_model type="johnson_cook">\n<A>89.6e6</A> <B>292.0e6</B> <C>0.025</C> <n>0.31</n>\n<m>1.09</m>\n'


class Vanishing(NamedTuple):
    """A law of a user's own whose strength falls to nothing."""

    yield_stress: float


@flow_stress.register(Vanishing)
def _(flow, hardening_variable, plastic_strain, plastic_rate, temperature):
    return flow.yield_stress * (1.0 - 4.0 * plastic_strain), 0.0, -4.0 * flow.yield_stress, 0.0, 0.0


@pytest.mark.parametrize(
    ("slots", "told"),
    [
        ({"flow": LinearHardening(4e8, -1e8)}, "hardening_modulus = -100000000.0 Pa is out of its range"),
        ({"flow": LinearHardening(math.nan, 1e8)}, "yield_stress = nan Pa is out of its range"),
        ({"flow": LinearHardening("4e8", 1e8)}, "yield_stress = '4e8' is no number: give initial yield stress in Pa"),
        ({"flow": STEINBERG._replace(Y_max=0.1e9)}, "Y_max = 100000000.0 Pa is not above sigma_0 = 120000000.0"),
        ({"flow": STEINBERG._replace(Peierls_stress=5e7)}, "a Peierls_stress needs C1, C2"),
        ({"flow": STEINBERG._replace(A=2.83)}, "A = 2.83 1/Pa is out of its range: give a value >= 0 and <= 1e-09"),
        ({"flow": THRESHOLD._replace(sigma_i=1e9)}, "a sigma_i needs g_0i"),
        ({"flow": TabulatedHardening((0.0, 0.2, 0.1), (1e8, 2e8, 3e8))}, "must begin with 0 and rise"),
        ({"flow": TabulatedHardening((0.0, 0.2), (1e8, 0.0))}, "stresses = 0.0 Pa is out of its range"),
        ({"flow": Vanishing(1e8)}, "the yield surface shrinks to nothing: the flow stress is -"),
        ({"damage": HancockMackenzieDamage(0.8, 0.7)}, "critical_damage = 0.7 - is not above initial_damage = 0.8"),
        (
            {"yield_condition": Gurson(1.5, 1.0, 2.25, 4.0, 0.05), "damage": VoidNucleation(0.3, 0.0, 0.3, 0.1)},
            "the yield surface has shrunk to nothing at the initial porosity 0.3",
        ),
        ({"specific_heat": ConstantSpecificHeat(0.0)}, "value = 0.0 J/(kg K) is out of its range"),
        ({"shear_modulus": VarshniShearModulus(80e9, 3e9, 180.0)}, "describe the same stiffness"),
        (
            {"melting": BurakovskyMelting(170e9, 5.0, 80e9, 1.5, 1.0, 8.0, 0.78, 1.5, 1.3, 2.87e-10, 0.5, 1.38e-23)},
            "nothing melts above 0 K",
        ),
    ],
)  # fmt: skip
def test_bad_numbers_of_a_material_made_in_python_are_refused(copper, slots, told):
    """Out of range, no number, not ascending, at odds with each other: one line that names law and number."""
    with pytest.raises(MaterialError) as refused:
        replace(copper("hypo", "linear"), name="odd copper", **slots)
    message = str(refused.value)
    assert message.startswith("odd copper: ") and told in message and "\n" not in message


@pytest.mark.parametrize(
    ("law", "told"),
    [
        ("voce", "the flow stress falls with plastic strain from 0 on"),
        ("table", "the flow stress falls with plastic strain from 0.2 on"),
        ("damage", "the failure strain turns negative"),
        ("cone", "with alpha = 0.6, not below 1 / sqrt(3) = 0.577"),
    ],
)
def test_what_should_be_known_is_logged(copper, caplog, law, told):
    """Softening, a failure strain below 0, no yielding in compression: the material is made, with a warning."""
    slots = {
        "voce": {"flow": Voce(300e6, 100e6, 10.0, 0.0)},
        "table": {"flow": TabulatedHardening((0.0, 0.1, 0.5), (1e8, 2e8, 1e8))},
        "damage": {"damage": JohnsonCookDamage(-0.77, 1.45, -0.47, 0.0, 1.6, 294.0, 925.0)},
        "cone": {"yield_condition": DruckerPrager(0.6, 0.1)},
    }[law]
    replace(copper("hypo", "linear"), **slots)
    assert [record.levelname for record in caplog.records] == ["WARNING"]
    assert f"hypo-linear: {told}" in caplog.text


def test_hardening_laws_are_made_without_a_word(pool, flow_laws, copper, caplog):
    """No warning for the laws and cards that harden."""
    for law in flow_laws:
        copper("hypo", law)
    for name, path in shipped_materials().items():
        if "6061" not in name:
            read_material(path)
    assert not [record for record in caplog.records if record.levelno >= logging.WARNING]


def test_cards_tell_softening_with_file_and_line(read_card, caplog, tmp_path):
    """The warning points at the block of the flow law."""
    softening = (
        '<plasticity_model type="voce">\n<sigma_0>3e8</sigma_0>\n'
        "<sigma_inf>1e8</sigma_inf><delta>10</delta>\n<H>0</H>"
    )
    read_card((FLOW, softening))
    assert f"{tmp_path}/card.xml:10: card: the flow stress falls" in caplog.text


def test_cards_refuse_a_limit_below_the_yield_stress(refused):
    """Uintah's SCGPlastic4340Steel.xml has Y_max 0.25e9, surely 2.5e9: file, line, both numbers."""
    block = (
        '<plasticity_model type="steinberg_cochran_guinan"><mu_0> 81.8e9 </mu_0> <sigma_0> 1.15e9 </sigma_0>\n'
        "<Y_max> 0.25e9 </Y_max> <beta> 2.0 </beta> <n> 0.50 </n> <A> 20.6e-12 </A> <B> 0.16e-3 </B>\n"
        "<T_m0> 2310.0 </T_m0> <Gamma_0> 3.0 </Gamma_0> <a> 1.67 </a> <epsilon_p0> 0.0 </epsilon_p0>"
    )
    message = refused(CardError, 11, (FLOW, block))
    assert (
        "Y_max = 250000000.0 is not above sigma_0 = 1150000000.0" in message and "give Y_max above" in message
    )


def test_preston_without_p_is_the_limit(copper):
    """p = 0, as in Uintah's PTWPlasticTa.xml: the material is made, its strength is that of a very small p."""
    at = (0.0, 0.1, 1e3, 300.0)
    limit = flow_stress(copper("hypo", PRESTON).flow, *at)[0]
    assert limit == pytest.approx(flow_stress(PRESTON._replace(p=1e-7), *at)[0], rel=1e-6)


def moved(material, gradient):
    """Two points with a deformation gradient."""
    points = MaterialPoints(material, np.ones(2))
    points.deformation_gradient = gradient
    return points


@pytest.mark.parametrize(
    ("build", "told"),
    [
        (lambda m: MaterialPoints(m, np.array([1.0, math.nan])), "a reference volume of nan m^3"),
        (lambda m: MaterialPoints(m, -np.ones(1)), "a reference volume of -1 m^3"),
        (lambda m: MaterialPoints(m, np.ones(1), temperature=-3.0), "a temperature of -3 K"),
        (
            lambda m: MaterialPoints(m, []),
            "reference_volumes has the shape (0,): give numbers of the shape (n,)",
        ),
        (lambda m: MaterialPoints(m, np.ones((2, 3))), "reference_volumes has the shape (2, 3): give"),
        (lambda m: MaterialPoints(m, ["a", 1.0]), "reference_volumes is no array of numbers: give one of"),
        (lambda m: moved(m, np.ones((3, 3))).advance(1.0), "deformation_gradient has the shape (3, 3): give"),
        (lambda m: MaterialPoints(m, np.ones(1)).advance(0.0), "a time step must be positive, not 0 s"),
        (
            lambda m: MaterialPoints(m, np.ones(1)).advance(math.nan),
            "a time step must be positive, not nan s",
        ),
    ],
)
def test_points_refuse_what_no_body_has(copper, build, told):
    """Volumes, temperatures and time steps that are negative or no numbers: a typed error, before any kernel runs."""
    with pytest.raises(SceneError, match=re.escape(told)) as refused:
        build(copper("hypo", "linear"))
    assert "\n" not in str(refused.value)

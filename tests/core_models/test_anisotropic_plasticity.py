"""Plastic flow with anisotropic elasticity: closed forms, surface, dissipation, objectivity, tangent, cards."""

from dataclasses import replace

import numpy as np
import pytest
from lxml import etree
from scipy.spatial.transform import Rotation

from core_models.cards.reader import parse_material
from core_models.cards.writer import material_element
from core_models.driver import drive, drive_program
from core_models.elasticity.isotropic import IsotropicElastic
from core_models.elasticity.orthotropic import OrthotropicElastic
from core_models.eos.default_hypo import DefaultHypoelastic
from core_models.eos.mie_gruneisen import MieGruneisen
from core_models.erosion.delete import DeletePoint
from core_models.erosion.zero_stress import ZeroStress
from core_models.errors import MaterialError
from core_models.flow.johnson_cook import JohnsonCook
from core_models.flow.linear import LinearHardening
from core_models.kinematic_hardening.armstrong_frederick import ArmstrongFrederick
from core_models.kinematic_hardening.chaboche import Chaboche
from core_models.loading_paths import uniaxial_stress
from core_models.material import Material
from core_models.melting.constant import ConstantMelting
from core_models.objective_rate.logarithmic import Logarithmic
from core_models.paths import turned as turned_path
from core_models.points import MaterialPoints
from core_models.shear_modulus.constant import ConstantShearModulus
from core_models.updates.hyperelastic_plastic import HyperelasticPlastic
from core_models.updates.hypoelastic_plastic import HypoelasticPlastic
from core_models.yield_condition.drucker_prager import DruckerPrager
from core_models.yield_condition.von_mises import VonMises
from studies.laws.sample_laws import SAMPLES
from tests.core_models.test_anisotropic_elasticity import (
    COPPER,
    FIBRES,
    GRADIENT,
    LAWS,
    PLY,
    TURN,
    body,
    compliance,
    turned,
)
from tests.core_models.test_general_tangent import mismatch
from tests.core_models.test_kinematic_hardening import wild_path

STRENGTH, MODULUS = 200e6, 2e9
FLOW = LinearHardening(STRENGTH, MODULUS)
HOT = JohnsonCook(200e6, 292e6, 0.025, 0.31, 1.09, 1.0, 294.0, 1356.0)
SUM = Chaboche((5e9, 1e9), (100.0, 0.0))
DIRECTION = np.array([[0.3, 0.9, -0.2], [-0.4, -0.6, 0.5], [0.1, 0.2, 0.7]])
FULL = [[0, 3, 5], [3, 1, 4], [5, 4, 2]]
each_law = pytest.mark.parametrize("law", LAWS[:3], ids=lambda law: type(law).__name__)

pytestmark = pytest.mark.usefixtures("interpreted")


def crystal(law, flow=FLOW, tolerance=1e-10, **slots):
    """A body of this elasticity that flows."""
    slots = {"yield_condition": None if flow is None else VonMises()} | slots
    return Material("crystal", 1600.0, HypoelasticPlastic(tolerance), law, flow=flow, **slots)


def about_z(law, degrees):
    """The law with its axes turned about z."""
    return turned(law, Rotation.from_euler("z", degrees, degrees=True).as_matrix())


def mises(stress):
    """Equivalent stress of (k, 6)."""
    normal = stress[:, :3] - stress[:, :3].mean(axis=1, keepdims=True)
    return np.sqrt(1.5 * (normal**2).sum(axis=1) + 3.0 * (stress[:, 3:] ** 2).sum(axis=1))


@each_law
def test_small_strains_give_the_stress_of_st_venant_kirchhoff(law):
    """With the same stiffness and axes, elastic, to the size of the strain."""
    path = np.array([np.eye(3), np.eye(3) + 1e-6 * GRADIENT])
    expected = drive(body(law), path, 1.0).stress[-1]
    found = drive(crystal(law), path, 1.0).stress[-1]
    assert found == pytest.approx(expected, abs=2e-6 * np.abs(expected).max())


@pytest.mark.parametrize("degrees", [0.0, 20.0, 45.0, 90.0])
@pytest.mark.parametrize("law", [PLY, COPPER, FIBRES], ids=lambda law: type(law).__name__)
def test_tension_at_an_angle_to_the_axes_is_the_closed_form(law, degrees):
    """Young's modulus 1 / S_11 of the direction up to the yield stress, E H / (E + H) from there on."""
    tilted = about_z(law, degrees)
    young = 1.0 / compliance(tilted)[0, 0]
    yielding = STRENGTH / young
    elastic = drive_program(crystal(tilted), uniaxial_stress(0.999 * yielding, 1.0, steps=2))
    assert elastic.fields["equivalent_plastic_strain"][-1] == 0.0
    assert elastic.stress[-1, 0] == pytest.approx(0.999 * STRENGTH, rel=0.02)
    history = drive_program(crystal(tilted), uniaxial_stress(yielding + 0.004, 1.0, steps=20))
    plastic = history.fields["equivalent_plastic_strain"]
    assert history.stress[-1, 0] == pytest.approx(STRENGTH + MODULUS * plastic[-1], rel=1e-8)
    axial = np.log(history.deformation_gradient[:, 0, 0])
    slope = np.diff(history.stress[-3:, 0]).sum() / np.diff(axial[-3:]).sum()
    assert slope == pytest.approx(young * MODULUS / (young + MODULUS), rel=0.02)


def test_isotropic_constants_give_the_radial_return():
    """Stress, plastic strain, dissipation and work, with a back stress and without."""
    young, poisson = 120e9, 0.3
    isotropic = IsotropicElastic.from_young(young, poisson)
    axes = ((1.0, 2.0, -2.0), (3.0, 0.0, 1.0))
    law = OrthotropicElastic(*[young] * 3, *[poisson] * 3, *[isotropic.shear_modulus] * 3, *axes)
    eos = DefaultHypoelastic(isotropic.bulk_modulus)
    path = wild_path(20, 0.003)
    for slots in ({}, {"kinematic_hardening": SUM}):
        found = drive(crystal(law, **slots), path, 1e-3)
        expected = drive(crystal(isotropic, eos=eos, **slots), path, 1e-3)
        deviators = [
            h.stress - h.stress[:, :3].mean(axis=1)[:, None] * [1, 1, 1, 0, 0, 0] for h in (found, expected)
        ]
        assert deviators[0] == pytest.approx(deviators[1], rel=1e-7, abs=1.0)
        assert found.plastic == pytest.approx(expected.plastic, rel=2e-2)
        assert found.fields["equivalent_plastic_strain"][-1] == pytest.approx(
            expected.fields["equivalent_plastic_strain"][-1], rel=1e-8
        )


@each_law
@pytest.mark.parametrize("flow", [FLOW, HOT], ids=["linear", "rate-dependent"])
@pytest.mark.parametrize("size", [1e-3, 0.3])
def test_stress_stays_on_or_inside_the_surface_and_flow_dissipates(law, flow, size):
    """q(s - alpha) to 1e-8 of the flow stress, in steps up to 30 %; dissipation net of what is stored."""
    history = drive(crystal(law, flow, kinematic_hardening=SUM), wild_path(25, size), 1e-3)
    plastic = history.fields["equivalent_plastic_strain"]
    assert plastic[-1] > 0.2 * size
    assert np.diff(history.plastic).min() >= 0.0
    if flow is FLOW:
        shifted = history.stress - history.fields["back_stress"].reshape(-1, 2, 6).sum(axis=1)
        strength = STRENGTH + MODULUS * plastic
        assert (mises(shifted) <= strength * (1.0 + 1e-8)).all()
        assert np.isclose(mises(shifted), strength, rtol=1e-8).any()


@each_law
def test_a_turned_path_turns_the_stress_and_the_axes(law):
    """With a large rotation on top of every step all tensors turn, and every scalar is the same."""
    path = wild_path(12, 0.03)
    spin = Rotation.random(len(path), rng=np.random.default_rng(2)).as_matrix()
    spin[0] = np.eye(3)
    material = crystal(law, kinematic_hardening=SUM)
    still, moving = (drive(material, each, 1e-3) for each in (path, turned_path(path, spin)))
    expected = spin @ still.stress[:, FULL] @ spin.transpose(0, 2, 1)
    assert moving.stress[:, FULL] == pytest.approx(expected, abs=1e-8 * np.abs(expected).max())
    assert moving.plastic == pytest.approx(still.plastic, rel=1e-8)
    assert moving.stress_work == pytest.approx(still.stress_work, rel=1e-8)


def test_axes_turned_in_the_card_and_body_turned_alike_are_the_same():
    """sigma(F Q^T; Q axes) = sigma(F; axes) over a path in the plastic range."""
    path = wild_path(8, 0.02)
    one = drive(crystal(LAWS[0]), path, 1e-3)
    turned_whole = TURN @ path @ TURN.T
    turned_whole[0] = np.eye(3)
    other = drive(crystal(turned(LAWS[0], TURN)), turned_whole, 1e-3)
    expected = TURN @ one.stress[:, FULL] @ TURN.T
    assert other.stress[:, FULL] == pytest.approx(expected, abs=1e-8 * np.abs(expected).max())


@each_law
@pytest.mark.parametrize("kinematic", [None, SUM])
@pytest.mark.parametrize("size", [0.004, 0.2])
def test_the_tangent_is_the_derivative(law, kinematic, size):
    """To 1e-6 against central differences, in the plastic range, in small and in large steps."""
    material = crystal(law, tolerance=1e-14, kinematic_hardening=kinematic)
    assert mismatch(material, size * DIRECTION, before=0.02) <= 1e-6


def test_what_has_melted_or_failed_carries_a_mean_stress_at_most():
    """A melt has no shear; an eroded point has nothing, a deleted one has not even a wave speed."""
    melting = crystal(LAWS[0], HOT, melting=ConstantMelting(1356.0))
    path = np.array([np.eye(3), np.eye(3) + 0.01 * GRADIENT])
    stress = drive(melting, path, 1e-3, temperature=1400.0).stress[-1]
    assert abs(stress[0]) > 1e6 and stress == pytest.approx([stress[0]] * 3 + [0.0] * 3, rel=1e-12, abs=1e-6)
    for erosion in (ZeroStress(), DeletePoint()):
        damage = SAMPLES["damage"][1]
        points = MaterialPoints(crystal(LAWS[0], damage=damage, erosion=erosion), np.ones(1))
        points.old.damage[0] = 1.0
        points.deformation_gradient[0] = path[1]
        points.advance(1e-3)
        assert np.abs(points.new.stress).max() == 0.0
        assert (points.wave_speed[0] == 0.0) == isinstance(erosion, DeletePoint)


@each_law
def test_card_out_and_in(law):
    """The card of a body that flows reads back equal."""
    material = crystal(law, kinematic_hardening=ArmstrongFrederick(5e9, 100.0))
    again = parse_material(etree.fromstring(etree.tostring(material_element(material))), "crystal").material
    assert again == material


@pytest.mark.parametrize(
    ("slots", "text"),
    [
        (
            {"update": HyperelasticPlastic()},
            "how the axes of the material have turned: take the update hypo",
        ),
        ({"eos": MieGruneisen(1600.0, 3940.0, 2.02, 1.489)}, "gives the mean stress as well"),
        ({"yield_condition": DruckerPrager(0.2, 0.1)}, "takes shape and volume apart.*take vonMises"),
        ({"objective_rate": Logarithmic()}, "turn with R of F = V R"),
        ({"shear_modulus": ConstantShearModulus(45e9)}, "no single shear modulus: leave shear_modulus out"),
        ({"expansion": SAMPLES["expansion"][0]}, "acts through the equation of state"),
    ],
)
def test_what_does_not_go_with_anisotropy_is_refused(slots, text):
    """With the slot, the reason, and what would fit."""
    with pytest.raises(MaterialError, match=text):
        replace(crystal(COPPER), **slots)


def test_every_law_beside_an_anisotropic_elasticity_is_driven_or_refused():
    """Each law of each slot, with an orthotropic body."""
    taken = set()
    for slot, laws in SAMPLES.items():
        for law in laws:
            if slot in ("update", "elasticity", "yield_condition"):
                continue
            needs = {"specific_heat": SAMPLES["specific_heat"][0]} if slot == "heating" else {}
            needs |= {"damage": SAMPLES["damage"][0]} if slot == "erosion" else {}
            try:
                material = replace(crystal(PLY), **(needs | {slot: law}))
            except MaterialError:
                continue
            history = drive(material, wild_path(4, 0.02), 1e-6)
            assert np.isfinite(history.stress).all() and np.isfinite(history.stress_work).all()
            taken.add(slot)
    assert taken == {
        "flow", "kinematic_hardening", "damage", "melting", "specific_heat", "heating", "erosion", "stability",
    }  # fmt: skip
    assert drive(crystal(PLY, None), wild_path(3, 0.01), 1e-3).plastic[-1] == 0.0

"""Drucker-Prager and Mohr-Coulomb whose cohesion is a flow law of rate and temperature, or weakened by damage."""

import numpy as np
import pytest

from core_models.damage.johnson_cook import JohnsonCookDamage
from core_models.driver import drive, drive_program
from core_models.elasticity.isotropic import IsotropicElastic
from core_models.eos.default_hypo import DefaultHypoelastic
from core_models.eos.neo_hookean import NeoHookean
from core_models.flow.johnson_cook import JohnsonCook
from core_models.heating.taylor_quinney import TaylorQuinney
from core_models.laws import flow_stress
from core_models.loading_paths import uniaxial_stress
from core_models.material import Material
from core_models.melting.constant import ConstantMelting
from core_models.paths import simple_shear
from core_models.points import MaterialPoints
from core_models.specific_heat.constant import ConstantSpecificHeat
from core_models.state import PointState
from core_models.updates.conditions import flow_before
from core_models.updates.hyperelastic_plastic import HyperelasticPlastic
from core_models.updates.hypoelastic_plastic import HypoelasticPlastic
from core_models.yield_condition.drucker_prager import DruckerPrager
from core_models.yield_condition.mohr_coulomb import MohrCoulomb
from studies.laws.sample_laws import BULK, DENSITY, SAMPLES, SHEAR
from tests.core_models.test_general_tangent import BEFORE, mismatch
from tests.core_models.test_pressure_dependent_yield import excess, wild_path

UPDATES = {"hypo": HypoelasticPlastic, "hyper": HyperelasticPlastic}
CONDITIONS = [DruckerPrager.from_friction(20, 5), MohrCoulomb(20, 5), MohrCoulomb(20, 20, 150e6)]
JC = JohnsonCook(90e6, 292e6, 0.025, 0.31, 1.09, 1.0, 294.0, 1356.0)
each_condition = pytest.mark.parametrize("condition", CONDITIONS, ids=lambda law: type(law).__name__)

pytestmark = pytest.mark.usefixtures("interpreted")


def rock(update, condition, flow, tolerance=1e-10, **slots):
    """A body of copper's stiffness whose cohesion is a flow law."""
    eos = DefaultHypoelastic(BULK) if update == "hypo" else NeoHookean(BULK)
    elastic = IsotropicElastic(BULK, SHEAR)
    return Material("rock", DENSITY, UPDATES[update](tolerance), elastic, eos, flow, condition, **slots)


def cohesions(material, history, row, dt):
    """The flow stress at the end of a step, at the rates between which round-off in the strain leaves the rate [Pa]."""
    fields = history.fields
    strain, increment = (
        fields["equivalent_plastic_strain"][row],
        np.diff(fields["equivalent_plastic_strain"])[row - 1],
    )
    kelvin = fields.get("temperature", np.full(len(history.stress), 294.0))[row - 1]
    variable = fields.get("hardening_variable", np.zeros(len(history.stress)))[row]
    before = PointState(
        tuple(history.stress[row - 1]),
        (),
        (),
        0.0,
        0.0,
        kelvin,
        fields.get("damage", [0.0] * 99)[row - 1],
        0.0,
    )
    flow = flow_before(material.model, before, np.linalg.det(history.deformation_gradient[row - 1]))
    doubt = 4e-16 * strain
    rates = (max(increment + change, 0.0) / dt for change in (-doubt, doubt))
    return [flow_stress(flow, variable, strain, rate, kelvin)[0] for rate in rates]


@each_condition
@pytest.mark.parametrize("number", [4, 6, 7, 9, 10, 11], ids=lambda n: type(SAMPLES["flow"][n]).__name__)
def test_the_stress_is_on_the_surface_of_its_rate(condition, number):
    """To 1e-8 of cohesion and round-off of K, over steps of 1e-4 to 0.1 at 1e-3 and 1e6 /s; flow dissipates."""
    flow = SAMPLES["flow"][number]
    for update, size, rate in (("hypo", 1e-4, 1e-3), ("hyper", 1e-2, 1e6), ("hypo", 0.1, 1e-3)):
        dt, path = size / rate, wild_path(6, size, 4)
        material = rock(update, condition, flow)
        history = drive(material, path, dt)
        measure = np.linalg.det(path) if update == "hyper" else np.ones(len(path))
        for row in range(1, len(path)):
            low, high = cohesions(material, history, row, dt)
            stress = measure[row] * history.stress[row : row + 1]
            slack = 1e-8 * high + 1e-14 * (BULK + np.abs(history.stress).max())
            assert excess(condition, stress, high)[0] <= slack
            grown = np.diff(history.fields["equivalent_plastic_strain"])[row - 1]
            if grown > 1e-12 and not np.isfinite(getattr(condition, "tension_cutoff", np.inf)):
                assert excess(condition, stress, low)[0] >= -slack
        assert history.fields["equivalent_plastic_strain"][-1] > 0.0 or size < 1e-2
        assert np.diff(history.plastic).min() >= -1e-9 * history.plastic[-1]


@pytest.mark.parametrize("update", UPDATES)
@each_condition
@pytest.mark.parametrize("flow", [JC, SAMPLES["flow"][7]], ids=lambda law: type(law).__name__)
def test_the_tangent_knows_the_rate(update, condition, flow):
    """To 1e-6 against central differences."""
    assert mismatch(rock(update, condition, flow, 1e-14), 0.05 * BEFORE.T, before=0.02) <= 1e-6


@pytest.mark.parametrize("update", UPDATES)
@pytest.mark.parametrize(
    ("condition", "factor"),
    [(MohrCoulomb(30, 10), 2.0 * np.sqrt(3.0)), (DruckerPrager.from_friction(30, 10), 2.0 * np.sqrt(3.0))],
    ids=["pyramid", "cone"],
)
def test_the_strength_in_compression_grows_with_the_rate_as_the_flow_law_does(update, condition, factor):
    """2 c cos / (1 - sin) with c of Johnson and Cook at the plastic strain and its rate."""
    for rate in (1.0, 1e3, 1e5):
        history = drive_program(rock(update, condition, JC), uniaxial_stress(-0.05, rate, steps=8))
        strain = history.fields["equivalent_plastic_strain"]
        plastic_rate = np.diff(strain)[-1] / (0.05 / rate / 8)
        cohesion = flow_stress(JC, 0.0, strain[-1], plastic_rate, 294.0)[0]
        measure = np.linalg.det(history.deformation_gradient[-1]) if update == "hyper" else 1.0
        assert -measure * history.stress[-1, 0] == pytest.approx(factor * cohesion, rel=1e-7)


@each_condition
def test_damage_and_heat_weaken_the_cohesion(condition):
    """Johnson-Cook damage coupled to the strength, and heat of the plastic work, up to melting."""
    damage = JohnsonCookDamage(0.2, 0.0, 0.0, 0.0, 0.0, 294.0, 1356.0, coupling=1.0)
    slots = {
        "damage": damage,
        "heating": TaylorQuinney(0.9),
        "specific_heat": ConstantSpecificHeat(383.0),
        "melting": ConstantMelting(1356.0),
    }
    path = simple_shear(np.linspace(0.0, 0.3, 16))
    strong, weak = (drive(rock("hypo", condition, JC, **more), path, 1e-5) for more in ({}, slots))
    assert weak.fields["damage"][-1] > 0.1 and weak.fields["temperature"][-1] > 300.0
    full, cohesion = (
        cohesions(material, history, len(path) - 1, 1e-5)[1]
        for material, history in (
            (rock("hypo", condition, JC), strong),
            (rock("hypo", condition, JC, **slots), weak),
        )
    )
    assert cohesion < 0.9 * full
    assert abs(excess(condition, weak.stress[-1:], cohesion)[0]) <= 1e-7 * cohesion
    points = MaterialPoints(rock("hypo", condition, JC, **slots), np.ones(1), temperature=1400.0)
    points.deformation_gradient[0] = path[1]
    points.advance(1e-5)
    assert points.new.stress[0] == pytest.approx([points.new.stress[0, 0]] * 3 + [0.0] * 3, abs=1e-3)

"""Back stresses with Drucker-Prager's cone and with other objective rates: loops, surface, dissipation, turns."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from core_models.driver import drive, drive_program
from core_models.elasticity.isotropic import IsotropicElastic
from core_models.eos.default_hypo import DefaultHypoelastic
from core_models.eos.neo_hookean import NeoHookean
from core_models.flow.linear import LinearHardening
from core_models.flow.perfect import PerfectPlasticity
from core_models.kinematic_hardening.chaboche import Chaboche
from core_models.kinematic_hardening.prager import Prager
from core_models.loading_paths import cyclic, simple_shear
from core_models.material import Material
from core_models.objective_rate.jaumann import Jaumann
from core_models.objective_rate.logarithmic import Logarithmic
from core_models.paths import turned
from core_models.updates.hyperelastic_plastic import HyperelasticPlastic
from core_models.updates.hypoelastic_plastic import HypoelasticPlastic
from core_models.yield_condition.drucker_prager import DruckerPrager
from core_models.yield_condition.von_mises import VonMises
from tests.core_models.test_kinematic_hardening import steel
from tests.core_models.test_pressure_dependent_yield import (
    BULK,
    COHESION,
    CONDITIONS,
    FULL,
    SHEAR,
    measured,
    wild_path,
)
from tests.core_models.test_pressure_dependent_yield import excess as excess_of

UPDATES = {"hypo": HypoelasticPlastic(), "hyper": HyperelasticPlastic()}
SUM = Chaboche((1e8, 1e7), (50.0, 0.0))

pytestmark = pytest.mark.usefixtures("interpreted")


def soil(update, condition, kinematic, flow=None, **slots):
    """A soil whose cone moves."""
    eos = DefaultHypoelastic(BULK) if update == "hypo" else NeoHookean(BULK)
    laws = (
        IsotropicElastic(BULK, SHEAR),
        eos,
        flow or PerfectPlasticity(COHESION),
        CONDITIONS.get(condition, condition),
    )
    return Material("soil", 2000.0, UPDATES[update], *laws, kinematic_hardening=kinematic, **slots)


@pytest.mark.parametrize("update", UPDATES)
def test_a_cone_without_friction_is_von_mises(update):
    """alpha = beta = 0 and k = sigma_y / sqrt(3): stress, back stress and dissipation along a random path."""
    path = wild_path(15, 0.02, 3)
    cone, round_surface = (
        drive(soil(update, condition, SUM), path, 1e-3)
        for condition in (DruckerPrager(0.0, 0.0, 1.0 / np.sqrt(3.0)), VonMises())
    )
    assert cone.stress == pytest.approx(round_surface.stress, rel=1e-7, abs=1.0)
    assert cone.fields["back_stress"] == pytest.approx(round_surface.fields["back_stress"], rel=1e-7, abs=1.0)
    assert cone.plastic == pytest.approx(round_surface.plastic, rel=1e-8)


@pytest.mark.parametrize("update", UPDATES)
def test_a_loop_of_shear_is_the_closed_form(update):
    """tau = k at the first yielding, slope G (C / 3) / (G + C / 3) after it, and 2 k back to the next yielding."""
    modulus, gamma = 3e8, 0.01
    material = soil(update, DruckerPrager(0.2, 0.0), Prager(modulus))
    history = drive_program(material, simple_shear(gamma, 1.0, steps=25, cycles=1))
    tangent = SHEAR * modulus / 3.0 / (SHEAR + modulus / 3.0)
    top = COHESION + tangent * (gamma - COHESION / SHEAR)
    assert history.stress[25, 3] == pytest.approx(top, rel=2e-3)
    assert history.stress[75, 3] == pytest.approx(-top, rel=2e-3)
    plastic = history.fields["equivalent_plastic_strain"]
    unloading = history.stress[26:76][np.diff(plastic)[25:75] == 0.0, 3]
    assert unloading.min() == pytest.approx(top - 2.0 * COHESION, abs=2.0 * SHEAR * gamma / 25)


@pytest.mark.parametrize("update", UPDATES)
@pytest.mark.parametrize("condition", ["cone", "cone-cut"])
@pytest.mark.parametrize("size", [1e-3, 0.3])
def test_the_shifted_stress_stays_within_the_cone_and_flow_dissipates(update, condition, size):
    """sqrt(J_2(s - alpha)) + 3 alpha m <= k to 1e-8 of the cohesion; dissipation net of what is stored."""
    history = drive(
        soil(update, condition, SUM, LinearHardening(COHESION, 2e6)), wild_path(25, size, 5), 1e-3
    )
    cohesion = COHESION + 2e6 * history.fields["equivalent_plastic_strain"]
    shifted = measured(history, update) - history.fields["back_stress"].reshape(-1, 2, 6).sum(axis=1)
    assert (excess_of(CONDITIONS[condition], shifted, cohesion) <= 1e-8 * cohesion).all()
    assert history.fields["equivalent_plastic_strain"][-1] > size
    assert np.diff(history.plastic).min() >= 0.0


@pytest.mark.parametrize("update", UPDATES)
def test_a_turned_path_turns_stress_and_back_stress(update):
    """With a large rotation on top of every step."""
    path = wild_path(12, 0.02, 3)
    spin = Rotation.random(len(path), rng=np.random.default_rng(2)).as_matrix()
    spin[0] = np.eye(3)
    still, moving = (drive(soil(update, "cone", SUM), each, 1e-3) for each in (path, turned(path, spin)))
    expected = spin @ still.stress[:, FULL] @ spin.transpose(0, 2, 1)
    assert moving.stress[:, FULL] == pytest.approx(expected, abs=1e-8 * np.abs(expected).max())
    assert moving.plastic == pytest.approx(still.plastic, rel=1e-8)


@pytest.mark.parametrize("rate", [Logarithmic(), Jaumann()])
def test_without_rotation_all_rates_give_the_same_loop(rate):
    """Uniaxial stress to and fro."""
    material = steel("hypo", Prager(10e9))
    loop = cyclic(0.01, 1.0, steps=5)
    expected = drive_program(material, loop)
    found = drive_program(replace(material, objective_rate=rate), loop)
    assert found.stress[:, 0] == pytest.approx(expected.stress[:, 0], rel=1e-4, abs=1e5)


@pytest.mark.parametrize(
    ("rate", "expected"),
    [
        (Logarithmic(), lambda gamma: 2.0 * np.arcsinh(0.5 * gamma) / np.sqrt(4.0 + gamma**2)),
        (Jaumann(), lambda gamma: 0.5 * np.sin(gamma)),
    ],
)
def test_back_stresses_follow_the_rate_in_large_shear(rate, expected):
    """2/3 C ln V with the logarithmic rate, C / 3 sin(gamma) with Jaumann's, but for the elastic strain, up to 4."""
    shear, modulus = np.tile(np.eye(3), (81, 1, 1)), 3e9
    shear[:, 0, 1] = np.linspace(0.0, 4.0, 81)
    history = drive(replace(steel("hypo", Prager(modulus)), objective_rate=rate), shear, 1e-2)
    found = history.fields["back_stress"][:, 3]
    assert found == pytest.approx(2.0 / 3.0 * modulus * expected(shear[:, 0, 1]), abs=0.02 * modulus / 3.0)

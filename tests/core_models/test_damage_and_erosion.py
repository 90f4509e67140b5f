"""Johnson-Cook damage, and what erosion leaves of a failed point."""

import numpy as np
import pytest

from core_models.damage.johnson_cook import JohnsonCookDamage
from core_models.driver import drive
from core_models.erosion.no_shear import AllowNoShear
from core_models.erosion.no_tension import AllowNoTension
from core_models.erosion.zero_stress import ZeroStress
from core_models.laws import damage_increment, eroded_stress
from core_models.paths import principal_stretches

COPPER = JohnsonCookDamage(0.54, 4.89, -3.03, 0.014, 1.12, 294.0, 1356.0)
STEEL = JohnsonCookDamage(0.05, 3.44, -2.12, 0.002, 0.61, 294.0, 1793.0)
IRON = JohnsonCookDamage(-2.2, 5.43, -0.47, 0.016, 0.63, 294.0, 1811.0)
ALUMINIUM = JohnsonCookDamage(-0.77, 1.45, -0.47, 0.0, 1.60, 294.0, 925.0)

FAILURE_STRAINS = """-0.333333333333 13.9660 7.0236 4.1510
                      0.0             5.4300 3.4900 3.2300
                      0.333333333333  2.3210 1.7469 2.4426
                      0.6             1.3339 1.0141 1.8957
                      1.0             0.7763 0.4629 1.1938
                      1.5             0.5919 0.1931 0.4830"""


STRAIN = np.linspace(0.0, 1.5, 151)
TENSION = principal_stretches(np.exp(STRAIN), np.exp(-0.48 * STRAIN), np.exp(-0.48 * STRAIN))


def failure_strain(law, triaxiality, rate=1.0, temperature=294.0):
    """Plastic strain at which the damage variable reaches 1 in a steady state."""
    return 1e-3 / damage_increment(law, 1e-3, rate, temperature, triaxiality * 2e8, 2e8)


@pytest.mark.parametrize("line", FAILURE_STRAINS.splitlines())
def test_failure_strains(line):
    """Copper, 4340 steel and Armco iron over triaxiality, to half a unit of the last printed digit."""
    triaxiality, *printed = (float(word) for word in line.split())
    for law, value in zip((COPPER, STEEL, IRON), printed, strict=True):
        assert failure_strain(law, triaxiality) == pytest.approx(value, abs=0.51e-4)


def test_rate_and_temperature_delay_failure():
    """eps_f grows with ln(rate) above 1 /s only, and with T* between T_r and T_m only."""
    reference = failure_strain(COPPER, 0.4)
    assert failure_strain(COPPER, 0.4, rate=1e-4) == reference
    assert failure_strain(COPPER, 0.4, rate=1e4) == pytest.approx(reference * (1.0 + 0.014 * np.log(1e4)))
    assert failure_strain(COPPER, 0.4, temperature=100.0) == reference
    assert failure_strain(COPPER, 0.4, temperature=825.0) == pytest.approx(reference * 1.56)
    assert failure_strain(COPPER, 0.4, temperature=5000.0) == pytest.approx(reference * 2.12)


def test_damage_never_heals():
    """Sets whose failure strain turns negative at high triaxiality fail at once instead; triaxiality is bounded."""
    assert failure_strain(ALUMINIUM, 1.4) == 1e-3
    assert failure_strain(COPPER, 9.0) == failure_strain(COPPER, 1.5)
    assert failure_strain(COPPER, -9.0) == failure_strain(COPPER, -1.5)


def test_no_plastic_strain_no_damage():
    """Elastic steps and stress-free points take no damage that is not plastic."""
    assert damage_increment(COPPER, 0.0, 0.0, 294.0, 1e9, 1e8) == 0.0
    assert damage_increment(COPPER, 1e-3, 1.0, 294.0, 1e9, 0.0) == pytest.approx(1e-3 / 5.43)


@pytest.mark.parametrize(
    ("law", "in_tension", "in_compression"),
    [(ZeroStress(), 0.0, 0.0), (AllowNoTension(), 0.0, -3e8), (AllowNoShear(), 3e8, -3e8)],
    ids=lambda law: type(law).__name__,
)
def test_a_failed_point_carries_what_its_erosion_allows(law, in_tension, in_compression):
    """Below damage 1 nothing changes; from 1 on there is no shear, and tension or pressure as the law says."""
    deviator = (2e8, -1e8, -1e8, 5e7, 0.0, 0.0)
    assert eroded_stress(law, 0.999, deviator, 3e8) == (deviator, 3e8)
    assert eroded_stress(law, 1.0, deviator, 3e8) == ((0.0,) * 6, in_tension)
    assert eroded_stress(law, 1.5, deviator, -3e8) == ((0.0,) * 6, in_compression)


def test_damage_without_erosion_is_reported_and_does_not_act(pool):
    """A point stretched far beyond damage 1 keeps the strength of its flow law."""
    history = drive(pool["hypo-jc-hot"], TENSION, 1e-6)
    assert history.fields["damage"][-1] > 1.2
    assert history.stress[-1, 0] - history.stress[-1, 1] > 3e8


def test_erosion_acts_from_the_step_after_failure(hot_copper):
    """A point with zero-stress erosion carries no stress once its damage has reached 1, and its strength until then."""
    material = hot_copper("hypo", "jc", erosion=ZeroStress())
    history = drive(material, TENSION, 1e-6)
    damage, carried = history.fields["damage"], np.abs(history.stress).max(axis=1)
    failed = np.flatnonzero(damage >= 1.0)[0]
    assert np.all(carried[failed + 1 :] == 0.0)
    assert np.all(carried[1 : failed + 1] > 5e7)

"""Johnson-Cook damage, and what erosion leaves of a failed point."""

from dataclasses import replace

import numpy as np
import pytest

from core_models.damage.hancock_mackenzie import HancockMackenzieDamage
from core_models.damage.johnson_cook import JohnsonCookDamage
from core_models.damage.sandia import SandiaDamage
from core_models.driver import drive
from core_models.elasticity.cubic import CubicElastic
from core_models.eos.neo_hookean import NeoHookean
from core_models.erosion.delete import DeletePoint
from core_models.erosion.no_shear import AllowNoShear
from core_models.erosion.no_tension import AllowNoTension
from core_models.erosion.preserve_stress import PreserveStress
from core_models.erosion.zero_stress import ZeroStress
from core_models.kinematic_hardening.prager import Prager
from core_models.laws import damage_increment, eroded_stress
from core_models.paths import principal_stretches
from core_models.points import MaterialPoints, PointFailure
from core_models.yield_condition.drucker_prager import DruckerPrager

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


@pytest.mark.usefixtures("interpreted")
def test_erosion_acts_from_the_step_after_failure(hot_copper):
    """A point with zero-stress erosion carries no stress once its damage has reached 1, and its strength until then."""
    material = hot_copper("hypo", "jc", erosion=ZeroStress())
    history = drive(material, TENSION, 1e-6)
    damage, carried = history.fields["damage"], np.abs(history.stress).max(axis=1)
    failed = np.flatnonzero(damage >= 1.0)[0]
    assert np.all(carried[failed + 1 :] == 0.0)
    assert np.all(carried[1 : failed + 1] > 5e7)


ANISOTROPIC = {
    "elasticity": CubicElastic(168.4e9, 121.4e9, 75.4e9, (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)),
    "eos": None,
}
DECAYING = [ZeroStress, AllowNoTension, AllowNoShear, DeletePoint]


@pytest.mark.usefixtures("interpreted")
@pytest.mark.parametrize("law", DECAYING)
@pytest.mark.parametrize("update", ["hypo", "hyper"])
def test_what_erosion_takes_decays_in_time(hot_copper, update, law):
    """After failure the flow stress falls as exp(-t / decay_time), and so does tension where the law takes it."""
    material = hot_copper(update, "linear", erosion=law(2e-6), heating=None, eos=NeoHookean(136.35e9))
    history = drive(material, TENSION, 1e-6)
    damage, strain = history.fields["damage"], history.fields["equivalent_plastic_strain"]
    failed = np.flatnonzero(damage >= 1.0)[0]
    assert np.diff(damage[failed : failed + 20]) == pytest.approx(0.5)
    left = np.minimum(np.exp(1.0 - damage[:-1]), 1.0)
    measure = np.linalg.det(history.deformation_gradient[1:]) if update == "hyper" else 1.0
    assert history.mises[1:] * measure == pytest.approx(
        (400e6 + 100e6 * strain[1:]) * left, rel=1e-9, abs=500.0
    )
    carried = {AllowNoShear: 1.0}.get(law, left[-1])
    whole = drive(replace(material, erosion=PreserveStress()), TENSION, 1e-6).pressure[-1]
    assert history.pressure[-1] == pytest.approx(whole * carried, rel=1e-6, abs=1e6)


@pytest.mark.usefixtures("interpreted")
def test_preserved_stress_is_that_of_a_point_that_has_not_failed(hot_copper):
    """The law marks the point, by its damage, and takes nothing."""
    kept, free = (
        drive(hot_copper("hypo", "jc", erosion=law), TENSION, 1e-6) for law in (PreserveStress(), None)
    )
    assert kept.fields["damage"][-1] > 1.2
    assert np.array_equal(kept.stress, free.stress)


@pytest.mark.usefixtures("interpreted")
@pytest.mark.parametrize("update", ["hypo", "hyper"])
@pytest.mark.parametrize(
    "laws",
    [{}, {"kinematic_hardening": Prager(1e9)}, {"yield_condition": DruckerPrager(0.2, 0.1)}, ANISOTROPIC],
    ids=["radial", "moving", "cone", "anisotropic"],
)
def test_a_deleted_point_follows_anything_and_carries_nothing(hot_copper, update, laws):
    """Even an inverted deformation gradient, with tangents too; neighbours are not touched."""
    if laws is ANISOTROPIC and update == "hyper":
        return
    material = hot_copper(update, "jc", erosion=DeletePoint(), **laws)
    points = MaterialPoints(material, np.ones(2))
    stresses, tangents = np.ones((2, 3, 3)), np.ones((2, 9, 9))
    for step in (points.advance, lambda dt: points.linearise(dt, stresses, tangents)):
        points.old.damage[0] = 1.0
        points.deformation_gradient[0] = np.diag([-1.0, 1.0, 1.0])
        points.deformation_gradient[1] = np.diag([1.001, 1.0, 1.0])
        step(1e-6)
        assert not points.new.stress[0].any() and points.new.stress[1, 0] > 1e8
        assert points.wave_speed[0] < 1e-3 * points.wave_speed[1]
    assert not stresses[0].any() and not tangents[0].any() and tangents[1].max() > 1e10
    points.accept()
    assert all(np.isfinite(field.array).all() for field in points.fields().values())
    points.old.damage[0] = 0.5
    points.deformation_gradient[0] = np.diag([-1.0, 1.0, 1.0])
    with np.errstate(all="ignore"), pytest.raises(PointFailure, match="inverted"):
        points.advance(1e-6)


@pytest.mark.usefixtures("interpreted")
@pytest.mark.parametrize("update", ["hypo", "hyper"])
@pytest.mark.parametrize(
    "damage",
    [COPPER, HancockMackenzieDamage(0.0, 1.0), SandiaDamage(6.0, 1e-3, 0.1)],
    ids=lambda law: type(law).__name__,
)
def test_coupled_damage_weakens_the_flow_stress(copper, update, damage):
    """The stress lies on a yield surface of (1 - coupling D) of its size, D being that before the step."""
    weak = drive(copper(update, "linear", damage=damage._replace(coupling=0.8)), TENSION[:9], 1e-6)
    values, strains = weak.fields["damage"], weak.fields["equivalent_plastic_strain"]
    assert values[-1] > 0.01
    strength = (400e6 + 100e6 * strains[1:]) * (1.0 - 0.8 * np.minimum(values[:-1], 1.0))
    measure = np.linalg.det(weak.deformation_gradient[1:]) if update == "hyper" else 1.0
    assert weak.mises[1:] * measure == pytest.approx(strength, rel=1e-9)


def test_coupled_damage_that_nothing_regularises_is_told(copper, caplog):
    """A warning, as for any softening."""
    copper("hypo", "linear", damage=COPPER)
    assert not caplog.records
    copper("hypo", "linear", damage=COPPER._replace(coupling=0.5))
    assert "nothing regularises the softening" in caplog.text

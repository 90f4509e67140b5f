"""What both stress updates have in common: limits, edges, convergence."""

import numpy as np
import pytest

from core_models.driver import drive
from core_models.flow.johnson_cook import JohnsonCook
from core_models.heating.taylor_quinney import TaylorQuinney
from core_models.paths import isochoric_tension, principal_stretches, rotations, simple_shear
from core_models.specific_heat.constant import ConstantSpecificHeat

PLASTIC = [
    "hypo-linear",
    "hyper-linear",
    "hypo-power",
    "hyper-voce",
    "hypo-jc-hot",
    "hyper-jc-hot",
    "hyper-mts-hot",
]
RATE_INDEPENDENT = [
    "hypo-elastic",
    "hyper-elastic",
    "hypo-linear",
    "hyper-linear",
    "hypo-power",
    "hyper-voce",
]


def deviatoric_size(stress):
    """Largest component of the deviator of a stress (6,)."""
    return np.abs(stress - np.r_[[stress[:3].mean()] * 3, 0.0, 0.0, 0.0]).max()


def bent_path(steps, size=0.3):
    """Shear and stretch with a change of direction."""
    t = np.linspace(0.0, 1.0, steps + 1)
    return simple_shear(size * t**2) @ isochoric_tension(np.exp(size * np.sin(2.5 * t)))


@pytest.mark.parametrize("name", PLASTIC)
def test_no_motion_leaves_the_state_untouched(pool, name):
    """Steps without strain leave every field of an undeformed point as it was, bit by bit."""
    history = drive(pool[name], np.tile(np.eye(3), (20, 1, 1)), 1e-6)
    for array in history.fields.values():
        assert np.array_equal(array[-1], array[0])
    assert history.stress_work[-1] == history.plastic[-1] == 0.0


@pytest.mark.parametrize("name", RATE_INDEPENDENT)
def test_a_point_held_in_place_stays_as_it_is(pool, name):
    """Held at a large strain, a rate-independent material changes by no more than round-off in 1,000 steps."""
    path = np.vstack([bent_path(20), np.tile(bent_path(20)[-1], (1000, 1, 1))])
    history = drive(pool[name], path, 1e-6)
    for field, array in history.fields.items():
        assert array[-1] == pytest.approx(array[20], rel=1e-11, abs=1e-11 * np.abs(array).max()), field


@pytest.mark.parametrize("update", ["hypo", "hyper"])
def test_a_rate_dependent_point_relaxes_to_its_static_strength(pool, update):
    """Held still after a fast strain, Johnson-Cook's overstress goes, and no further than to the slow strength."""
    material = pool[f"{update}-jc-hot"]
    path = np.vstack([bent_path(20), np.tile(bent_path(20)[-1], (30, 1, 1))])
    fast, slow = (drive(material, path, [1e-7] * 20 + [hold] * 30) for hold in (1e-4, 1e3))
    held = [deviatoric_size(history.stress[-1]) for history in (fast, slow)]
    moving = deviatoric_size(fast.stress[20])
    assert 0.7 * moving < held[1] < 0.8 * moving
    assert held[0] == pytest.approx(held[1], rel=1e-4)


@pytest.mark.parametrize("name", ["hypo-jc-hot", "hyper-jc-hot", "hyper-mts-hot"])
@pytest.mark.parametrize("temperature", [1356.0, 1400.0, 5000.0])
def test_molten_metal_carries_no_shear(pool, name, temperature):
    """At and above the melting temperature there is pressure but no deviator, no plastic strain and no heat."""
    path = principal_stretches(*np.exp(np.outer(np.linspace(0.0, 0.1, 11), [1.0, -0.2, -1.0])).T)
    history = drive(pool[name], path, 1e-7, temperature=temperature)
    mean = history.stress[:, :3].mean(axis=1)
    assert np.all(mean[1:] < -1e8)
    assert history.stress[:, :3] == pytest.approx(np.tile(mean, (3, 1)).T, rel=1e-15)
    assert np.all(history.stress[:, 3:] == 0.0)
    assert np.all(history.plastic == 0.0)
    assert np.all(history.fields["temperature"] == temperature)


@pytest.mark.parametrize("name", ["hypo-jc-hot", "hyper-mts-hot"])
def test_strength_fades_towards_melting(pool, name):
    """Just below melting a metal still flows, with little strength or none, and nothing goes wrong."""
    sizes = [
        deviatoric_size(drive(pool[name], bent_path(20), 1e-7, temperature=t).stress[-1])
        for t in (300.0, 800.0, 1300.0, 1355.9)
    ]
    assert np.all(np.diff(sizes) <= 0.0)
    assert sizes[-1] < 0.6 * sizes[0]


@pytest.mark.parametrize("name", ["hypo-jc-hot", "hyper-jc-hot", "hyper-mts-hot"])
@pytest.mark.parametrize("temperature", [0.0, 1.0, 77.0])
def test_cold_metal_is_strong_and_finite(pool, name, temperature):
    """Down to absolute zero the laws give finite stresses, none weaker than at room temperature."""
    cold, warm = (drive(pool[name], bent_path(20), 1e-6, temperature=t) for t in (temperature, 294.0))
    assert deviatoric_size(cold.stress[-1]) >= 0.999 * deviatoric_size(warm.stress[-1])


@pytest.mark.parametrize("name", PLASTIC)
def test_first_yield_is_at_the_initial_strength(pool, name):
    """From ep = 0, where a power law has no slope, the first plastic step ends on the surface a little above it."""
    history = drive(pool[name], simple_shear(np.linspace(0.0, 0.03, 31)), 1e-3)
    strain = history.fields["equivalent_plastic_strain"]
    first = np.flatnonzero(strain > 0.0)[0]
    assert 0.0 < strain[first] < 1e-3
    assert deviatoric_size(history.stress[first]) > deviatoric_size(history.stress[first - 1])


@pytest.mark.parametrize("pair", [("hypo-elastic", "hyper-elastic"), ("hypo-jc-hot", "hyper-jc-hot")])
def test_updates_agree_for_small_elastic_strain(pool, pair):
    """With elastic strains of 1e-4 the two updates differ by 1e-4, also through large rotations."""
    steps = np.linspace(0.0, 1.0, 101)
    strain = np.exp(np.outer(steps, [1e-4, -2e-4, 0.5e-4]))
    spin = rotations([0.0, 0.0, 1.0], 2.0 * steps)
    one, other = (drive(pool[name], spin @ principal_stretches(*strain.T), 1e-6).stress for name in pair)
    assert one == pytest.approx(other, abs=4e-4 * np.abs(one).max())


def test_updates_agree_in_the_plastic_range(pool):
    """Johnson-Cook copper at 30 % strain: the two updates agree within the size of the elastic strain."""
    one, other = (drive(pool[name], bent_path(2000), 1e-8) for name in ("hypo-jc-hot", "hyper-jc-hot"))
    assert one.stress[-1] == pytest.approx(other.stress[-1], abs=0.01 * np.abs(one.stress[-1]).max())
    assert one.plastic[-1] == pytest.approx(other.plastic[-1], rel=2e-3)
    assert one.fields["temperature"][-1] == pytest.approx(other.fields["temperature"][-1], abs=0.2)


@pytest.mark.parametrize("name", PLASTIC)
def test_states_converge_with_the_step(pool, name):
    """Halving the step at least halves the error of the stress at the end of a bent plastic path."""
    fine = drive(pool[name], bent_path(6400), 1e-3 / 6400).stress[-1]
    errors = [
        np.abs(drive(pool[name], bent_path(n), 1e-3 / n).stress[-1] - fine).max() for n in (50, 100, 200, 400)
    ]
    assert errors[-1] < 5e-3 * np.abs(fine).max()
    assert np.log2(errors[0] / errors[-1]) / 3.0 > 0.95


def test_adiabatic_tension_follows_the_curve_of_johnson_cook(hot_copper):
    """OFHC copper at 1e4 /s from 294 K: stress [MPa] and temperature of the adiabatic curve, within 0.05 % and 0.1 K.

    The path sets the total rate; the plastic rate is lower by the share of elastic strain, 1 %.
    """
    material = hot_copper(
        "hypo",
        JohnsonCook(90e6, 292e6, 0.025, 0.31, 1.09, 1.0, 294.0, 1356.0),
        density=8960.0,
        eos=hot_copper("hypo", "jc").eos._replace(reference_density=8960.0),
        specific_heat=ConstantSpecificHeat(383.0),
        heating=TaylorQuinney(0.9),
    )
    history = drive(material, isochoric_tension(np.exp(np.linspace(0.0, 1.02, 10201))), 1e-8)
    strain = history.fields["equivalent_plastic_strain"]
    strength = history.stress[:, 0] - history.stress[:, 1]
    for ep, mpa, kelvin in [
        (0.1, 285.58, 300.41),
        (0.3, 352.47, 317.39),
        (0.5, 388.38, 336.89),
        (1.0, 435.22, 391.34),
    ]:
        assert np.interp(ep, strain, strength) / 1e6 == pytest.approx(mpa, rel=5e-4)
        assert np.interp(ep, strain, history.fields["temperature"]) == pytest.approx(kelvin, abs=0.1)

"""Shear modulus, melting temperature and specific heat against their papers, tables and limits."""

import cmath
import math

import numpy as np
import pytest

from core_models.laws import heat_capacity, melting_temperature, shear_modulus
from core_models.melting.burakovsky_preston_silbar import BurakovskyMelting
from core_models.melting.constant import ConstantMelting
from core_models.melting.steinberg_cochran_guinan import SteinbergMelting
from core_models.shear_modulus.constant import ConstantShearModulus
from core_models.shear_modulus.nadal_le_poac import NadalLePoac
from core_models.shear_modulus.preston_tonks_wallace import PrestonShearModulus
from core_models.shear_modulus.steinberg_cochran_guinan import SteinbergShearModulus
from core_models.shear_modulus.varshni import VarshniShearModulus
from core_models.specific_heat.copper import CopperSpecificHeat
from core_models.specific_heat.steel import SteelSpecificHeat

BOLTZMANN = 1.380649e-23
ATOMIC_MASS = 1.66053906660e-27
IRON_MELTING = BurakovskyMelting(
    1.66e11, 5.29, 0.819e11, 1.8, 1.0, 8.0, 0.78, 2.9, 1.30, 5.4057 * 0.53e-10, 0.5, 1.3806503e-23
)
COPPER_MELTING = SteinbergMelting(1356.5, 1.99, 1.5)


def complex_step(function, arguments, index):
    """Derivative of a function by one of its arguments, to round-off."""
    shifted = [complex(x) for x in arguments]
    step = 1e-30 * abs(shifted[index])
    shifted[index] += 1j * step
    return complex(function(*shifted)).imag / step


def varshni(law, _density_ratio, temperature, _pressure, _melting):
    """Shear modulus [Pa]."""
    return law.mu_0 - law.D / (cmath.exp(law.T_0 / temperature) - 1.0)


def steinberg_modulus(law, density_ratio, temperature, pressure, _melting):
    """Shear modulus [Pa]."""
    return law.mu_0 * (1.0 + law.A * pressure / density_ratio ** (1.0 / 3.0) - law.B * (temperature - 300.0))


def preston_modulus(law, density_ratio, temperature, pressure, melting):
    """Shear modulus [Pa]."""
    stiffening = 1.0 + law.slope_mu_p_over_mu0 * pressure / density_ratio ** (1.0 / 3.0)
    return law.mu_0 * stiffening * (1.0 - law.alphap * temperature / melting)


def nadal_le_poac(law, density_ratio, temperature, pressure, melting):
    """Shear modulus [Pa], with J as the paper writes it."""
    t = temperature / melting
    j = 1.0 + cmath.exp(-(1.0 + 1.0 / law.zeta) / (1.0 + law.zeta / (1.0 - t)))
    stiffening = 1.0 + law.slope_mu_p_over_mu0 * pressure / density_ratio ** (1.0 / 3.0)
    vibration = law.density * density_ratio * BOLTZMANN * temperature / (law.C * law.m * ATOMIC_MASS)
    return (law.mu_0 * stiffening * (1.0 - t) + vibration) / j


MODULI = {
    "varshni": (VarshniShearModulus(47.7e9, 3e9, 180.0), varshni),
    "steinberg": (SteinbergShearModulus(47.7e9, 2.83e-11, 3.77e-4), steinberg_modulus),
    "preston": (PrestonShearModulus(51.8e9, 0.20, 28e-12), preston_modulus),
    "nadal": (NadalLePoac(50.7e9, 0.04, 28e-12, 0.057, 63.55, 8930.0), nadal_le_poac),
}


@pytest.mark.parametrize("name", MODULI)
def test_modulus_and_its_slopes_are_those_of_the_paper(name):
    """Over density, temperature, pressure and melting: the value to round-off, the slopes to 1e-9."""
    law, transcription = MODULI[name]
    random = np.random.default_rng(2)
    for _ in range(300):
        melting = random.uniform(1300.0, 3000.0)
        state = (
            random.uniform(0.9, 1.5),
            random.uniform(20.0, 0.999 * melting),
            random.uniform(-1e9, 1e11),
            melting,
        )
        if name == "steinberg" and steinberg_modulus(law, *state).real <= 1e6:
            continue
        modulus, *slopes = shear_modulus(law, *state)
        assert modulus == pytest.approx(transcription(law, *map(complex, state)).real, rel=1e-12)
        for index, slope in enumerate(slopes):
            exact = complex_step(lambda *x: transcription(law, *x), state, index)
            assert slope * state[index] == pytest.approx(exact * state[index], rel=1e-9, abs=1e-10 * modulus)


def test_varshni_modulus_of_copper():
    """44.0832 GPa at 298 K; the 0 K modulus in the cold."""
    law = MODULI["varshni"][0]
    assert shear_modulus(law, 1.0, 298.0, 0.0, math.inf)[0] == pytest.approx(44.0832e9, abs=0.5e5)
    assert shear_modulus(law, 1.0, 0.0, 0.0, math.inf) == (
        pytest.approx(47.7e9, rel=1e-15),
        0.0,
        0.0,
        0.0,
        0.0,
    )


@pytest.mark.parametrize("name", MODULI)
def test_modulus_stays_positive(name):
    """Absolute zero, melting, twice that, strong tension and no melting at all: finite, above 0."""
    law = MODULI[name][0]
    for temperature in (0.0, 300.0, 1356.0, 1400.0, 1411.0, 2800.0, 1e5):
        for pressure in (-1e12, -1e10, 0.0, 1e12):
            for melting in (1356.0, math.inf):
                result = shear_modulus(law, 1.0, temperature, pressure, melting)
                assert np.all(np.isfinite(result))
                assert result[0] > 0.0


def test_nadal_le_poac_falls_to_nothing_about_melting():
    """Most of the modulus is there at 0.9 T_m, half or less at T_m, nothing beyond 1.04 T_m."""
    law = MODULI["nadal"][0]
    cold, warm, melting, above = (
        shear_modulus(law, 1.0, t * 1356.0, 0.0, 1356.0)[0] for t in (0.2, 0.9, 1.0, 1.05)
    )
    assert cold > warm > 2.0 * melting > 1e3 * above
    assert above == 1e-6 * law.mu_0


def test_constant_modulus():
    """Nothing changes it."""
    assert shear_modulus(ConstantShearModulus(46e9), 1.2, 900.0, 1e10, 1356.0) == (46e9, 0.0, 0.0, 0.0, 0.0)


def test_melting_of_steinberg_cochran_and_guinan():
    """1892.54 K for copper compressed to 0.9 of its volume; T_m0 at rest, and whatever the pressure."""
    assert melting_temperature(COPPER_MELTING, 1.0 / 0.9) == pytest.approx(1892.54, abs=0.005)
    assert melting_temperature(COPPER_MELTING) == melting_temperature(COPPER_MELTING, 1.0, 1e10) == 1356.5


def test_melting_of_burakovsky_preston_and_silbar():
    """Iron: T_m(0) worked out by hand, the formula under pressure, finite and not negative in tension."""
    volume = (5.4057 * 0.53e-10) ** 3 / 2.0
    energy = 1.30 * 0.819e11 * volume / (8.0 * math.pi * math.log(7.0)) * math.log(2.9**2 / (4.0 * 0.78))
    at_rest = melting_temperature(IRON_MELTING)
    assert at_rest == pytest.approx(energy / 1.3806503e-23, rel=1e-12)
    assert 1700.0 < at_rest < 1900.0
    eta = (1.0 + 5.29 * 1e11 / 1.66e11) ** (1.0 / 5.29)
    expected = at_rest * (1.0 / eta + eta ** (-4.0 / 3.0) * 1.8 / 0.819e11 * 1e11)
    assert melting_temperature(IRON_MELTING, 1.0, 1e11) == pytest.approx(expected, rel=1e-12)
    assert 0.0 <= melting_temperature(IRON_MELTING, 1.0, -1e12) < at_rest


def test_melting_without_density_and_pressure():
    """A constant needs neither, and nothing melts without a law."""
    assert melting_temperature(ConstantMelting(1356.0)) == melting_temperature(
        ConstantMelting(1356.0), 1.2, 1e10
    )
    assert melting_temperature(None, 1.2, 1e10) == math.inf


@pytest.mark.parametrize(
    ("law", "temperature", "capacity"),
    [
        (CopperSpecificHeat(), 294.0, 388.07),
        (CopperSpecificHeat(), 718.0, 430.85),
        (SteelSpecificHeat(), 298.0, 442.35),
        (SteelSpecificHeat(), 800.0, 687.82),
    ],
)
def test_specific_heat(law, temperature, capacity):
    """Copper and steel, cold and warm [J/(kg K)]."""
    assert heat_capacity(law, temperature) == pytest.approx(capacity, rel=1e-4)


@pytest.mark.parametrize(
    "law", [CopperSpecificHeat(), SteelSpecificHeat()], ids=lambda law: type(law).__name__
)
def test_specific_heat_is_positive_and_finite_everywhere(law):
    """Also at 0 K, at the Curie point and far above melting."""
    capacities = [heat_capacity(law, temperature) for temperature in (*range(0, 5000), 1040.0, 1040.001)]
    assert min(capacities) > 0.0
    assert max(capacities) < 2000.0

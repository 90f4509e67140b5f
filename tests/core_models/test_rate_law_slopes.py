"""Values and slopes of the flow laws that were added later, against their papers in complex arithmetic."""

import cmath

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq
from scipy.special import erf

from core_models.flow.anand import Anand
from core_models.flow.mts import MechanicalThreshold
from core_models.flow.preston_tonks_wallace import PrestonTonksWallace
from core_models.flow.steinberg_cochran_guinan import SteinbergCochranGuinan
from core_models.flow.tabulated import TabulatedHardening
from core_models.flow.thermal_voce import ThermalVoce
from core_models.flow.zerilli_armstrong import ZerilliArmstrong
from core_models.laws import evolve_hardening, flow_stress, under_pressure

ATOMIC_MASS = 1.66053906660e-27

COPPER_PTW = PrestonTonksWallace(
    0.025, 2.0, 0.0085, 0.00055, 0.11, 1e-5, 1e-4, 1e-4, 0.094, 0.575, 0.25, 63.54, 51.8e9, 0.2, 28e-12, 8930.0, 1360.0
)  # fmt: skip
TANTALUM_PTW = PrestonTonksWallace(
    0.02, 0.0, 0.012, 0.00325, 0.6, 4e-5, 0.01, 0.00125, 0.012, 0.4, 0.23, 180.948, 72.2e9, 0.48, 14.5e-12, 16690.0,
    3290.0,
)  # fmt: skip
STEEL_PTW = COPPER_PTW._replace(
    p=10.0, s0=0.05, sinf=0.0075, kappa=0.3, gamma=1e-3, y0=0.0069, yinf=0.0015, y1=0.05
)
COPPER_SCG = SteinbergCochranGuinan(0.12e9, 36.0, 0.45, 0.0, 0.64e9, 2.83e-11, 3.77e-4, 1790.0, 2.02, 1.5)
COPPER_LUND = COPPER_SCG._replace(C1=0.71e6, C2=0.012e6, energy_to_form_kink_pair=0.31, Peierls_stress=0.5e8)
SOLDER = Anand(56.33e6, 10830.0, 1.49e7, 11.0, 0.303, 2640.75e6, 80.415e6, 0.0231, 1.34)
HY100 = MechanicalThreshold(
    40e6, 0.905e6, 1e7, 1.6, 1.0, 0.666667, 3.0, 1e7, 0.112, 822e6, 6e9, 0.0, 0.0, 2.0758e6, 200e6, 71.46e9, 2.9e9,
    204.0, 71.46e9, 1341e6, 1.161, 1e13, 0.5, 1.5,
)  # fmt: skip
TABLE = TabulatedHardening((0.0, 0.1, 0.3, 1.0), (90e6, 200e6, 260e6, 300e6))


def larger(a, b):
    """The one with the larger real part."""
    return a if a.real >= b.real else b


def smaller(a, b):
    """The one with the smaller real part."""
    return a if a.real <= b.real else b


def complex_step(function, arguments, index):
    """Derivative of a function by one of its arguments, to round-off."""
    shifted = [complex(x) for x in arguments]
    step = 1e-30 * abs(shifted[index])
    shifted[index] += 1j * step
    return complex(function(*shifted)).imag / step


def zerilli_armstrong(law, _variable, strain, rate, temperature):
    """Flow stress [Pa]; the paper's exponents, not below 0."""
    alpha = larger(law.alpha_0 - law.alpha_1 * cmath.log(rate), 0j)
    beta = larger(law.beta_0 - law.beta_1 * cmath.log(rate), 0j)
    athermal = law.sigma_g + law.k_H * law.sqrt_l_inv + law.K * strain**law.n
    return (
        athermal
        + law.B * cmath.exp(-beta * temperature)
        + law.B_0 * cmath.sqrt(strain) * cmath.exp(-alpha * temperature)
    )


def steinberg(law, _variable, strain, rate, temperature):
    """Flow stress [Pa] below melting."""
    hardened = law.sigma_0 * (1.0 + law.beta * (strain + law.epsilon_p0)) ** law.n
    ratio = 1.0 - law.B * (temperature - 300.0)
    thermal = kink_pairs(law, rate, temperature) if law.Peierls_stress else 0.0
    return (thermal + smaller(hardened, complex(law.Y_max))) * ratio


def kink_pairs(law, rate, temperature):
    """Lund's sigma_T [Pa]: a bracketed real root, then Newton steps that carry the imaginary part."""
    a = 2.0 * law.energy_to_form_kink_pair / (law.Boltzmann_constant * temperature)
    if 1.0 / (1.0 / law.C1 + law.C2 / law.Peierls_stress) <= rate.real:
        return complex(law.Peierls_stress)

    def excess(x, a=a, rate=rate):
        return cmath.exp(a * (1.0 - x) ** 2) / law.C1 * rate + law.C2 / (law.Peierls_stress * x) * rate - 1.0

    x = complex(brentq(lambda x: excess(x, a.real, rate.real).real, 1e-30, 1.0, xtol=1e-300, rtol=1e-15))
    for _step in range(3):
        kinks = cmath.exp(a * (1.0 - x) ** 2) / law.C1 * rate
        x -= excess(x) / (-2.0 * a * (1.0 - x) * kinks - law.C2 / (law.Peierls_stress * x * x) * rate)
    return law.Peierls_stress * x


def preston_tonks_wallace(law, _variable, strain, rate, temperature):
    """Flow stress [Pa] below melting."""
    mu = law.G0 * (1.0 - law.alphap * temperature / law.melting_temperature)
    atoms = law.density / (law.M * ATOMIC_MASS)
    e = rate / (0.5 * (4.0 * cmath.pi / 3.0 * atoms) ** (1.0 / 3.0) * cmath.sqrt(mu / law.density))
    x = larger(law.kappa * temperature / law.melting_temperature * cmath.log(law.gamma / e), 0j)
    drag = law.s0 * (e / law.gamma) ** law.beta
    s = larger(law.s0 - (law.s0 - law.sinf) * erf(x), drag)
    y = larger(law.y0 - (law.y0 - law.yinf) * erf(x), smaller(law.y1 * (e / law.gamma) ** law.y2, drag))
    if abs((s - y).real) < 1e-12:
        return 2.0 * s * mu
    if law.p == 0.0:
        return 2.0 * mu * (s - (s - y) * cmath.exp(-law.theta * strain / (s - y)))
    scale = (law.s0 - y) / law.p
    b = (s - y) / scale
    inner = (1.0 - cmath.exp(-b)) * cmath.exp(-law.theta * strain / (scale * (cmath.exp(b) - 1.0)))
    return 2.0 * mu * (s + scale * cmath.log(1.0 - inner))


def anand(law, variable, _strain, rate, temperature):
    """Flow stress [Pa]."""
    z = rate / law.A * cmath.exp(law.Q_over_R / temperature)
    return variable / law.xi * cmath.asinh(z**law.m)


def thermal_voce(law, _variable, strain, _rate, temperature):
    """Flow stress [Pa] where nothing has softened to nothing."""
    first = law.yield_stress * (1.0 - law.yield_softening * (temperature - law.T_0))
    later = 1.0 - law.hardening_softening * (temperature - law.T_0)
    rise = law.saturation_stress * later - first
    hardening = rise * (1.0 - cmath.exp(-law.saturation_rate * strain))
    return first + hardening + law.linear_modulus * later * strain


def threshold(law, variable, _strain, rate, temperature):
    """Flow stress [Pa] of the threshold law with its intrinsic barrier, where neither factor is cut."""
    mu = law.b1 - law.b2 / (cmath.exp(law.b3 / temperature) - 1.0)

    def factor(g, reference, q, p):
        scale = law.koverbcubed * temperature / (g * mu)
        return (1.0 - (scale * cmath.log(reference / rate)) ** (1.0 / q)) ** (1.0 / p)

    evolving = factor(law.g_0e, law.edot_0e, law.q_e, law.p_e) * variable
    intrinsic = factor(law.g_0i, law.edot_0i, law.q_i, law.p_i) * law.sigma_i
    return law.sigma_a + (evolving + intrinsic) * mu / law.mu_0


LAWS = {
    "zerilli fcc": (ZerilliArmstrong(46.5e6, 5e6, 3.7, 0, 0, 0, 890e6, 0.0028, 1.15e-4, 0, 0), zerilli_armstrong),
    "zerilli bcc": (ZerilliArmstrong(65e6, 0, 0, 1033e6, 0.00698, 4.15e-4, 0, 0, 0, 266e6, 0.289), zerilli_armstrong),
    "steinberg": (COPPER_SCG, steinberg),
    "lund": (COPPER_LUND, steinberg),
    "preston": (COPPER_PTW, preston_tonks_wallace),
    "preston p = 10": (STEEL_PTW, preston_tonks_wallace),
    "preston p = 0": (TANTALUM_PTW, preston_tonks_wallace),
    "anand": (SOLDER, anand),
    "thermal voce": (ThermalVoce(450e6, 715e6, 16.93, 129.24e6, 6e-4, 5e-4, 293.15), thermal_voce),
}  # fmt: skip


def states(count, seed=0):
    """Hardening variables, strains, rates and temperatures below melting."""
    random = np.random.default_rng(seed)
    return zip(
        random.uniform(1e7, 3e8, count),
        10.0 ** random.uniform(-6.0, 0.5, count),
        10.0 ** random.uniform(-6.0, 9.0, count),
        random.uniform(80.0, 1300.0, count),
        strict=True,
    )


@pytest.mark.parametrize("name", LAWS)
def test_values_and_slopes_are_those_of_the_paper(name):
    """Stress and all four slopes agree with the law's equation and its complex-step derivatives to 1e-8."""
    law, transcription = LAWS[name]
    for state in states(300):
        stress, *slopes = flow_stress(law, *state)
        assert stress == pytest.approx(transcription(law, *map(complex, state)).real, rel=1e-10)
        for index, slope in enumerate(slopes):
            exact = complex_step(lambda *x: transcription(law, *x), state, index)
            assert slope * state[index] == pytest.approx(exact * state[index], rel=1e-8, abs=1e-9 * stress), (
                index
            )


def test_intrinsic_barrier_is_that_of_the_paper():
    """HY100 steel: stress and rate slope with both barriers; below the rates and temperatures where one is lost."""
    for variable, strain, rate, temperature in states(200):
        state = (variable, strain, min(rate, 1e6), 0.5 * temperature)
        stress, _by_variable, _by_strain, by_rate, _by_temperature = flow_stress(HY100, *state)
        assert stress == pytest.approx(threshold(HY100, *map(complex, state)).real, rel=1e-10)
        exact = complex_step(lambda *x: threshold(HY100, *x), state, 2)
        assert by_rate == pytest.approx(exact, rel=1e-8)


@pytest.mark.parametrize("a", [1.0, 1.34, 2.0])
def test_anand_resistance_solves_its_equation(a):
    """From below and from above its target, the resistance is that of the differential equation."""
    law = SOLDER._replace(a=a)
    rate, temperature, increment = 1e-3, 330.0, 0.03
    z = rate / law.A * np.exp(law.Q_over_R / temperature)
    target = law.s_hat * z**law.n

    def slope(_strain, s):
        return law.h_0 * np.abs(1.0 - s / target) ** a * np.sign(1.0 - s / target)

    for start in (0.5 * target, target, 1.4 * target):
        exact = solve_ivp(slope, (0.0, increment), [start], rtol=1e-11, atol=1e-2).y[0, -1]
        assert evolve_hardening(law, start, increment, rate, temperature)[0] == pytest.approx(exact, rel=1e-8)
    assert evolve_hardening(law, 4e7, 0.0, rate, temperature)[0] == pytest.approx(4e7, rel=1e-14)


def test_anand_resistance_is_kept_in_the_cold():
    """At 1 K its target is 1e108 times as large: it grows with h_0, and neither it nor its slopes are lost."""
    law, start, increment = SOLDER, 4e7, 1e-3
    new, slope, by_rate = evolve_hardening(law, start, increment, 1.0, 1.0)
    assert new == pytest.approx(start + law.h_0 * increment, rel=1e-12)
    assert slope == pytest.approx(law.h_0, rel=1e-12) and abs(by_rate) < 1e-9 * start


def test_anand_resistance_has_the_slopes_that_it_says():
    """Its slopes in the strain increment and in the rate agree with central differences."""
    random = np.random.default_rng(1)
    for _ in range(200):
        start, temperature = random.uniform(2e7, 1.2e8), random.uniform(233.0, 400.0)
        increment, rate = 10.0 ** random.uniform(-6.0, -1.0), 10.0 ** random.uniform(-6.0, 3.0)
        _new, slope, rate_slope = evolve_hardening(SOLDER, start, increment, rate, temperature)
        for value, analytic, index in ((increment, slope, 0), (rate, rate_slope, 1)):
            arguments = [increment, rate]
            h = 1e-5 * value
            arguments[index] = value + h
            above = evolve_hardening(SOLDER, start, *arguments, temperature)[0]
            arguments[index] = value - h
            below = evolve_hardening(SOLDER, start, *arguments, temperature)[0]
            assert analytic * value == pytest.approx((above - below) / 2e-5, rel=1e-6, abs=2e-8 * start)


@pytest.mark.parametrize(
    "law", [COPPER_SCG, COPPER_LUND, COPPER_PTW, TANTALUM_PTW], ids=lambda law: type(law).__name__
)
def test_pressure_scales_modulus_and_melting(law):
    """Under pressure the law is its own equation with the modulus, density and melting temperature there."""
    ratio, pressure, melting = 1.2, 30e9, 2500.0
    there = under_pressure(law, ratio, pressure, melting)
    state = (0.0, 0.2, 1e4, 900.0)
    if isinstance(law, SteinbergCochranGuinan):
        modulus = 1.0 + law.A * pressure / ratio ** (1 / 3) - law.B * 600.0
        scale = modulus / (1.0 - law.B * 600.0)
        assert flow_stress(there, *state)[0] == pytest.approx(scale * flow_stress(law, *state)[0], rel=1e-12)
        assert there.T_m0 == pytest.approx(
            1790.0 * np.exp(3.0 * (1.0 - 1.0 / 1.2)) * 1.2 ** (2 * (2.02 - 1.5 - 1 / 3))
        )
    else:
        modulus = law.G0 * (1.0 + law.slope_mu_p_over_mu0 * pressure / ratio ** (1 / 3))
        assert there == law._replace(
            G0=pytest.approx(modulus), density=law.density * ratio, melting_temperature=melting
        )
    at_rest = under_pressure(law, 1.0, 0.0, np.inf)
    assert flow_stress(at_rest, *state) == pytest.approx(flow_stress(law, *state), rel=1e-13)


def test_pressure_leaves_other_laws_alone():
    """A law that knows neither density nor pressure is handed back as it is."""
    assert under_pressure(SOLDER, 1.3, 50e9, 400.0) is SOLDER


def test_table_is_straight_between_its_points_and_constant_beyond():
    """Values at and between the points, slopes of the line on the left, no hardening beyond the last point."""
    strains = np.linspace(1e-6, 1.5, 400)
    stresses = [flow_stress(TABLE, 0.0, ep, 1.0, 300.0) for ep in strains]
    assert [s[0] for s in stresses] == pytest.approx(
        np.interp(strains, TABLE.strains, TABLE.stresses), rel=1e-14
    )
    assert flow_stress(TABLE, 0.0, 0.0, 1.0, 300.0) == (90e6, 0.0, pytest.approx(1.1e9), 0.0, 0.0)
    assert flow_stress(TABLE, 0.0, 0.1, 1.0, 300.0)[2] == pytest.approx(1.1e9)
    assert flow_stress(TABLE, 0.0, 0.2, 1.0, 300.0)[2] == pytest.approx(0.3e9)
    assert flow_stress(TABLE, 0.0, 1.2, 1.0, 300.0)[2] == 0.0

"""Flow stresses of the rate-dependent laws against tables that were worked out apart from this code, and their edges.

A value is right within 1e-4 of itself or half a unit of its last printed digit, whichever is larger.
"""

import math

import numpy as np
import pytest
from numba import njit

from core_models.flow.anand import Anand
from core_models.flow.mts import MechanicalThreshold
from core_models.flow.preston_tonks_wallace import PrestonTonksWallace
from core_models.flow.steinberg_cochran_guinan import SteinbergCochranGuinan
from core_models.flow.tabulated import TabulatedHardening
from core_models.flow.thermal_voce import ThermalVoce
from core_models.flow.voce import Voce
from core_models.flow.zerilli_armstrong import ZerilliArmstrong
from core_models.laws import evolve_hardening, flow_stress, shear_modulus, under_pressure
from core_models.shear_modulus.nadal_le_poac import NadalLePoac

STATES = [(0.1, 1.0, 294.0), (0.1, 4000.0, 696.0), (0.3, 1e4, 500.0), (1.0, 1e5, 900.0)]
ZERILLI = ZerilliArmstrong(46.5e6, 5e6, 3.7, 0.0, 0.0, 0.0, 890e6, 0.0028, 1.15e-4, 0.0, 0.0)
IRON = ZerilliArmstrong(65e6, 0.0, 0.0, 1033e6, 0.00698, 4.15e-4, 0.0, 0.0, 0.0, 266e6, 0.289)
OFHC = SteinbergCochranGuinan(0.12e9, 36.0, 0.45, 0.0, 0.64e9, 2.83e-11, 3.77e-4, 1790.0, 2.02, 1.5)
ETP_LUND = SteinbergCochranGuinan(
    0.125e9, 36.0, 0.45, 0.0, 0.64e9, 28e-12, 0.92e-3, 1790.0, 1.99, 1.5, 0.71e6, 0.012e6, 0.31, 8.617385e-5, 0.5e8
)  # fmt: skip
PRESTON = PrestonTonksWallace(
    0.025, 2.0, 0.0085, 0.00055, 0.11, 1e-5, 1e-4, 1e-4, 0.094, 0.575, 0.25, 63.54, 51.8e9, 0.2, 28e-12, 8930.0, 1360.0
)  # fmt: skip
NADAL = NadalLePoac(50.7e9, 0.04, 28e-12, 0.057, 63.55, 8930.0)
SOLDER = Anand(56.33e6, 10830.0, 1.49e7, 11.0, 0.303, 2640.75e6, 80.415e6, 0.0231, 1.34)
HY100 = MechanicalThreshold(
    40e6, 0.905e6, 1e7, 1.6, 1.0, 0.666667, 3.0, 1e7, 0.112, 822e6, 6e9, 0.0, 0.0, 2.0758e6, 200e6, 71.46e9, 2.9e9,
    204.0, 71.46e9, 1341e6, 1.161, 1e13, 0.5, 1.5,
)  # fmt: skip
THERMAL_VOCE = ThermalVoce(450e6, 715e6, 16.93, 129.24e6, 0.002, 0.002, 293.15)


def preston_with_nadal_le_poac(temperature):
    """The law with the modulus of Nadal and Le Poac at a temperature, as the table's author combined them."""
    modulus = shear_modulus(NADAL, 1.0, temperature, 0.0, PRESTON.melting_temperature)[0]
    return PRESTON._replace(G0=modulus, alphap=0.0)


def assert_printed(stress, printed):
    """The stress [Pa] is the one printed in MPa."""
    digits = len(printed.partition(".")[2])
    assert stress == pytest.approx(float(printed) * 1e6, rel=1e-4, abs=0.5 * 10.0 ** (6 - digits))


@pytest.mark.parametrize(
    ("law_at", "printed"),
    [
        (lambda temperature: ZERILLI, "188.560 142.866 269.145 300.759"),
        # B = 0.92e-3 /K is that of the ETP copper card, more than twice Steinberg's 3.77e-4: a test of the code only.
        (lambda temperature: ETP_LUND, "262.744 188.590 350.504 306.767"),
        (preston_with_nadal_le_poac, "169.664 154.998 326.931 321.295"),
    ],
    ids=["zerilli", "lund", "preston"],
)
def test_copper_at_four_states(law_at, printed):
    """Copper from 1 /s at room temperature to 1e5 /s at 900 K."""
    for (strain, rate, temperature), value in zip(STATES, printed.split(), strict=True):
        assert_printed(flow_stress(law_at(temperature), 0.0, strain, rate, temperature)[0], value)


@pytest.mark.parametrize(
    ("law", "columns", "table"),
    [
        (
            ZERILLI,
            [(1e-3, 298.0), (1e3, 298.0), (1e4, 298.0), (4e3, 696.0)],
            """0.1 161.43 219.82 232.53 142.87
               0.3 232.02 333.15 355.17 199.87
               0.5 280.62 411.19 439.61 239.11
               1   369.93 554.58 594.78 311.23""",
        ),
        (
            IRON,
            [(1.0, 298.0), (1e3, 298.0), (1e4, 298.0)],
            """0.1 330.78 504.96 604.85
               0.3 381.88 556.05 655.95""",
        ),
    ],
    ids=["copper", "iron"],
)
def test_zerilli_armstrong_tables(law, columns, table):
    """Fcc copper and bcc Armco iron over strain, rate and temperature."""
    for line in table.splitlines():
        strain, *printed = line.split()
        for (rate, temperature), value in zip(columns, printed, strict=True):
            assert_printed(flow_stress(law, 0.0, float(strain), rate, temperature)[0], value)


def test_steinberg_cochran_guinan_table():
    """OFHC copper at rest, under 10 GPa (at the density of rest, as the table has it) and hot."""
    columns = [(0.0, 300.0), (10e9, 300.0), (0.0, 696.0)]
    table = """0   120.00 153.96 102.08
               0.1 238.46 305.95 202.86
               0.3 364.36 467.47 309.96
               1   609.36 781.81 518.39
               2   640.00 821.12 544.45"""
    for line in table.splitlines():
        strain, *printed = line.split()
        for (pressure, temperature), value in zip(columns, printed, strict=True):
            law = under_pressure(OFHC, 1.0, pressure, math.inf)
            assert_printed(flow_stress(law, 0.0, float(strain), 1e5, temperature)[0], value)


def test_anand_tables():
    """60Sn40Pb solder: saturation stress over rate and temperature, and flow curves at constant rate."""
    for rate, *printed in (
        (1e-5, "70.20", "28.40", "5.13"),
        (1e-4, "82.27", "36.46", "9.30"),
        (1e-3, "95.44", "45.32", "14.85"),
        (1e-2, "109.81", "55.04", "21.38"),
    ):
        for temperature, value in zip((233.15, 298.15, 398.15), printed, strict=True):
            resistance = evolve_hardening(SOLDER, SOLDER.hardening_variable, 50.0, rate, temperature)[0]
            assert_printed(flow_stress(SOLDER, resistance, 50.0, rate, temperature)[0], value)
    columns = [(1e-3, 298.15), (1e-4, 298.15), (1e-3, 398.15)]
    curves = """1e-9  23.57 19.99 9.53
                0.005 25.51 21.51 10.06
                0.01  27.22 22.84 10.52
                0.02  30.10 25.07 11.27
                0.05  35.77 29.40 12.70
                0.1   40.29 32.80 13.78"""
    for line in curves.splitlines():
        strain, *printed = line.split()
        for (rate, temperature), value in zip(columns, printed, strict=True):
            resistance = evolve_hardening(
                SOLDER, SOLDER.hardening_variable, float(strain), rate, temperature
            )[0]
            assert_printed(flow_stress(SOLDER, resistance, float(strain), rate, temperature)[0], value)


@pytest.mark.parametrize(("stage_four", "printed"), [(200e6, "1300.6"), (0.0, "1254.8")])
def test_threshold_law_with_intrinsic_barrier(stage_four, printed):
    """HY100 steel at a strain of 0.5, 1e3 /s and 298 K, with and without stage IV."""
    law = HY100._replace(theta_IV=stage_four)
    threshold = evolve_hardening(law, 0.0, 0.5, 1e3, 298.0)[0]
    assert_printed(flow_stress(law, threshold, 0.5, 1e3, 298.0)[0], printed)


def test_strains_that_only_an_iteration_tries_cost_no_more_than_a_step():
    """An absurd strain is answered at once, and with numbers."""
    saturated = evolve_hardening(HY100._replace(theta_IV=0.0), 0.0, 2.0, 1e3, 298.0)[0]
    for strain in (1e3, 1e12):
        assert np.isfinite(
            evolve_hardening(HY100._replace(theta_IV=0.0), saturated, strain, 1e3, 298.0)
        ).all()


def test_thermal_voce_is_voce_at_its_temperature():
    """At T_0 nothing has softened; the bracket is linear, and 0 from 500 K above."""
    cold = Voce(450e6, 715e6, 16.93, 129.24e6)
    for strain in (0.0, 0.1, 1.0):
        stress, _, slope, _, _ = flow_stress(cold, 0.0, strain, 1.0, 293.15)
        assert flow_stress(THERMAL_VOCE, 0.0, strain, 1.0, 293.15)[:3:2] == pytest.approx(
            (stress, slope), rel=1e-14
        )
        assert flow_stress(THERMAL_VOCE, 0.0, strain, 1.0, 393.15)[0] == pytest.approx(
            0.8 * stress, rel=1e-14
        )
        assert flow_stress(THERMAL_VOCE, 0.0, strain, 1.0, 900.0) == (0.0, 0.0, 0.0, 0.0, 0.0)


@pytest.mark.parametrize(
    ("law_at", "warmest", "strongest"),
    [
        (lambda temperature: ZERILLI, 729.72, 258.581),
        (lambda temperature: ETP_LUND, 741.50, 351.368),
        (preston_with_nadal_le_poac, 735.48, 284.194),
    ],
    ids=["zerilli", "lund", "preston"],
)
def test_adiabatic_curve(law_at, warmest, strongest):
    """Heated by its own plastic work at 4000 /s from 696 K, copper reaches the tabulated state at a strain of 0.7."""
    temperature, steps = 696.0, 700
    increment = 0.7 / steps
    heat = 0.9 * increment * 1e6 / (8930.0 * 414.0)

    def stress(strain, kelvin):
        return flow_stress(law_at(kelvin), 0.0, strain, 4000.0, kelvin)[0] / 1e6

    for step in range(steps):
        warmer = temperature + 0.5 * heat * stress(step * increment, temperature)
        temperature += heat * stress((step + 0.5) * increment, warmer)
    assert temperature == pytest.approx(warmest, abs=0.01)
    assert stress(0.7, temperature) == pytest.approx(strongest, rel=1e-4)


LAWS = [ZERILLI, IRON, OFHC, ETP_LUND, PRESTON, PRESTON._replace(p=0.0), SOLDER, THERMAL_VOCE, HY100]
EDGES = [
    (strain, rate, temperature)
    for strain in (0.0, 1e-13, 1e-12, 0.5, 50.0)
    for rate in (0.0, 1e-14, 1e-9, 1.0, 1e8, 1e14)
    for temperature in (0.0, 1.0, 20.0, 300.0, 1359.9, 1790.0, 1e4)
]


@pytest.mark.parametrize("law", LAWS, ids=lambda law: type(law).__name__)
def test_edges_are_finite_and_not_negative(law):
    """No strain, no rate, absolute zero, melting and far beyond: finite numbers, no negative stress or rate slope."""
    for state in EDGES:
        result = flow_stress(law, getattr(law, "hardening_variable", 0.0), *state)
        assert np.all(np.isfinite(result)), state
        assert result[0] >= 0.0
        assert result[3] >= 0.0


@pytest.mark.parametrize("law", LAWS, ids=lambda law: type(law).__name__)
def test_stress_grows_with_the_rate_and_continuously(law):
    """Over fourteen decades of rate the stress never falls, and no step of a thousandth makes it jump."""
    variable = 1e8 if hasattr(law, "hardening_variable") else 0.0
    rates = np.geomspace(1e-13, 1e10, 53001)
    stresses = np.array([flow_stress(law, variable, 0.2, rate, 350.0)[0] for rate in rates[::10]])
    assert np.all(np.diff(stresses) >= -1e-12 * stresses[:-1])
    assert np.all(np.diff(stresses) <= 0.01 * stresses[1:] + 1.0)


@pytest.mark.parametrize("law", [OFHC, PRESTON], ids=lambda law: type(law).__name__)
def test_no_strength_at_and_above_melting(law):
    """From the law's own melting temperature on it is exactly 0, just below it is not."""
    melting = law.melting_temperature if isinstance(law, PrestonTonksWallace) else law.T_m0
    assert flow_stress(law, 0.0, 0.1, 1e3, melting) == (0.0, 0.0, 0.0, 0.0, 0.0)
    assert flow_stress(law, 0.0, 0.1, 1e3, 2.0 * melting)[0] == 0.0
    assert flow_stress(law, 0.0, 0.1, 1e3, 0.999 * melting)[0] > 1e6


def test_preston_limit_of_no_p():
    """p = 0 is the limit of small p."""
    law = PRESTON._replace(p=0.0)
    for strain, rate, temperature in STATES:
        limit = flow_stress(law, 0.0, strain, rate, temperature)
        near = flow_stress(law._replace(p=1e-7), 0.0, strain, rate, temperature)
        assert near == pytest.approx(limit, rel=1e-6)


def test_anand_resistance_is_the_law_s_own_at_the_start():
    """Points begin with s_0, and a resistance above its target falls."""
    assert SOLDER.hardening_variable == 56.33e6
    assert evolve_hardening(SOLDER, 1.2e8, 0.01, 1e-5, 398.15)[0] < 1.2e8


@njit(error_model="numpy")
def compiled(laws, state, out):
    """Stress and slopes of all laws as kernels compute them."""
    out[0] = flow_stress(laws[0], *state)
    out[1] = flow_stress(laws[1], *state)
    out[2] = flow_stress(laws[2], *state)
    out[3] = flow_stress(laws[3], *state)
    out[4] = flow_stress(laws[4], *state)
    out[5] = flow_stress(laws[5], *state)
    out[6] = flow_stress(under_pressure(laws[2], 1.1, 1e9, 1500.0), *state)


def test_compiled_laws_are_the_python_ones():
    """Every law compiles, and then says what it says in plain Python."""
    table = TabulatedHardening((0.0, 0.1, 0.3), (90e6, 200e6, 260e6))
    laws, state = (ZERILLI, ETP_LUND, PRESTON, SOLDER, THERMAL_VOCE, table), (5e7, 0.2, 1e3, 400.0)
    out = np.zeros((7, 5))
    compiled(laws, state, out)
    pressed = under_pressure(PRESTON, 1.1, 1e9, 1500.0)
    expected = [flow_stress(law, *state) for law in (*laws, pressed)]
    assert out == pytest.approx(np.array(expected), rel=1e-12)

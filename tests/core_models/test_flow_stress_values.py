"""Flow stresses against tables that were worked out apart from this code.

Tables: rows of plastic strain and of the stress [MPa] at each rate [1/s] and temperature [K]. A value is right within
1e-4 of itself or half a unit of its last printed digit, whichever is larger.
"""

import numpy as np
import pytest

from core_models.flow.johnson_cook import JohnsonCook
from core_models.laws import evolve_hardening, flow_stress

COPPER = JohnsonCook(89.6e6, 292e6, 0.025, 0.31, 1.09, 1.0, 294.0, 1356.0)
OFHC = COPPER._replace(A=90e6)
STEEL = JohnsonCook(792e6, 510e6, 0.014, 0.26, 1.03, 1.0, 294.0, 1793.0)
ALUMINIUM = JohnsonCook(324e6, 114e6, 0.002, 0.42, 1.34, 1.0, 294.0, 925.0)
IRON = JohnsonCook(175e6, 380e6, 0.06, 0.32, 0.55, 1.0, 294.0, 1811.0)

JOHNSON_COOK_POINTS = [
    (COPPER, 0.1, 1.0, 294.0, "232.6154"),
    (COPPER, 0.1, 4000.0, 696.0, "183.4387"),
    (COPPER, 0.3, 1e4, 500.0, "297.7261"),
    (COPPER, 1.0, 1e5, 900.0, "224.8186"),
    (STEEL._replace(T_r=298.0), 0.1, 1e3, 500.0, "1026.331"),
    (ALUMINIUM, 0.1, 1e3, 400.0, "338.305"),
]
JOHNSON_COOK_TABLES = [
    (
        OFHC,
        [(1.0, 294.0), (1e3, 294.0), (1e4, 294.0), (1e4, 600.0), (1e4, 900.0)],
        """0.05 205.36 240.83 252.65 187.56 115.58
           0.1  233.02 273.26 286.67 212.82 131.14
           0.2  267.30 313.46 328.84 244.13 150.44
           0.3  291.04 341.31 358.06 265.82 163.80
           0.5  325.54 381.76 400.50 297.33 183.22
           1    382.00 447.97 469.96 348.89 214.99
           2    451.99 530.05 556.07 412.82 254.39""",
    ),
    (
        STEEL,
        [(1.0, 294.0), (1e3, 294.0), (1e4, 294.0), (1e4, 700.0)],
        """0.05 1026.05 1125.27 1158.35 856.67
           0.1  1072.27 1175.96 1210.53 895.26
           0.3  1164.93 1277.58 1315.14 972.62
           1    1302.00 1427.91 1469.89 1087.07""",
    ),
    (
        IRON,
        [(1.0, 294.0), (1e4, 294.0), (1e4, 700.0)],
        """0.1 356.88 554.10 285.73
           0.3 433.50 673.06 347.07
           1   555.00 861.70 444.35""",
    ),
]
THRESHOLD_STATES = [(0.1, 1.0, 294.0), (0.1, 4000.0, 696.0), (0.3, 1e4, 500.0), (1.0, 1e5, 900.0)]
THRESHOLD_ROWS = [
    (47.7e9, ["177.245", "154.4445", "298.057", "331.780"]),
    (45.78e9, ["170.092", "146.892", "283.238", "308.794"]),
]
THRESHOLD_COLUMNS = [
    (1e-3, 298.0), (1.0, 298.0), (1e3, 298.0), (4e3, 298.0), (1e4, 298.0), (0.1, 296.0), (4e3, 696.0), (4e3, 873.0)
]  # fmt: skip
THRESHOLD_TABLE = """0.1 162.09 176.63 194.35 199.93 204.82 171.97 154.44 134.63
                     0.3 257.55 289.82 328.38 338.94 347.46 279.39 239.95 199.33
                     0.5 302.45 344.40 394.39 407.43 417.61 330.80 279.44 228.17
                     1   356.84 411.71 476.99 493.17 505.30 393.85 326.56 261.56"""


def assert_printed(stress, printed):
    """The stress [Pa] is the one printed in MPa."""
    digits = len(printed.partition(".")[2])
    expected = float(printed) * 1e6
    assert stress == pytest.approx(expected, rel=1e-4, abs=0.5 * 10.0 ** (6 - digits))


def rows(table):
    """Plastic strain and printed stresses of every row."""
    for line in table.splitlines():
        strain, *printed = line.split()
        yield float(strain), printed


def threshold_stress(law, strain, rate, temperature):
    """Flow stress after straining at constant rate and temperature."""
    variable = evolve_hardening(law, 0.0, strain, rate, temperature)[0]
    return flow_stress(law, variable, strain, rate, temperature)[0]


@pytest.mark.parametrize(("law", "strain", "rate", "temperature", "printed"), JOHNSON_COOK_POINTS)
def test_johnson_cook_at_single_states(law, strain, rate, temperature, printed):
    """Copper, 4340 steel and 6061 aluminium."""
    assert_printed(flow_stress(law, 0.0, strain, rate, temperature)[0], printed)


def test_johnson_cook_below_reference_rate_and_temperature():
    """Neither a rate below epdot_0 nor a temperature below T_r changes A + B ep^n, and both join continuously."""
    cold = flow_stress(COPPER, 0.0, 0.2, 1e-3, 250.0)
    assert cold[0] == pytest.approx(89.6e6 + 292e6 * 0.2**0.31, rel=1e-14)
    assert cold[3] == cold[4] == 0.0
    assert flow_stress(COPPER, 0.0, 0.2, 1.0 + 1e-12, 294.0 + 1e-9)[0] == pytest.approx(cold[0], rel=1e-10)


@pytest.mark.parametrize(("law", "columns", "table"), JOHNSON_COOK_TABLES, ids=["copper", "steel", "iron"])
def test_johnson_cook_tables(law, columns, table):
    """OFHC copper, 4340 steel and Armco iron over strain, rate and temperature."""
    for strain, printed in rows(table):
        for (rate, temperature), value in zip(columns, printed, strict=True):
            assert_printed(flow_stress(law, 0.0, strain, rate, temperature)[0], value)


@pytest.mark.parametrize(("b1", "printed"), THRESHOLD_ROWS)
def test_threshold_stress_solves_its_differential_equation(flow_laws, b1, printed):
    """The exact solution at constant rate, with one modulus for both roles and with the founding card's b1."""
    for state, value in zip(THRESHOLD_STATES, printed, strict=True):
        assert_printed(threshold_stress(flow_laws["mts"]._replace(b1=b1), *state), value)


def test_threshold_stress_table(flow_laws):
    """Copper with one modulus for both roles over strain, rate and temperature."""
    law = flow_laws["mts"]._replace(b1=47.7e9)
    for strain, printed in rows(THRESHOLD_TABLE):
        for state, value in zip(THRESHOLD_COLUMNS, printed, strict=True):
            assert_printed(threshold_stress(law, strain, *state), value)


def test_threshold_stress_remembers_its_rate_history(flow_laws):
    """The threshold is a true history variable: a jump in rate leaves it where it was, and then goes another way."""
    law = flow_laws["mts"]
    slow = evolve_hardening(law, 0.0, 0.1, 1.0, 294.0)[0]
    assert evolve_hardening(law, slow, 0.0, 1e5, 294.0)[0] == slow
    jumped = evolve_hardening(law, slow, 0.1, 1e5, 294.0)[0]
    steady = evolve_hardening(law, 0.0, 0.2, 1e5, 294.0)[0]
    assert jumped < 0.97 * steady


def test_stage_four_is_the_slope_at_saturation(flow_laws):
    """At sigma_es, 547.18 MPa for copper at 1 /s and 298 K, the threshold stress grows with theta_IV."""
    for stage_four in (0.0, 200e6):
        law = flow_laws["mts"]._replace(b1=47.7e9, theta_IV=stage_four)
        assert evolve_hardening(law, 547.18e6, 0.0, 1.0, 298.0)[1] == pytest.approx(stage_four, abs=1e5)


def adiabatic(law, rate, start, density, capacity, end):
    """Flow stresses [Pa] and temperatures [K] of a point that 0.9 of its plastic work heats, each 1/4000 of strain."""
    step = 1.0 / 4000
    heat = 0.9 * step / (density * capacity)
    temperature, stresses, temperatures = start, [], []
    for number in range(round(4000 * end)):
        middle, after = (number + 0.5) * step, (number + 1) * step
        warmer = temperature + 0.5 * heat * flow_stress(law, 0.0, middle, rate, temperature)[0]
        temperature += heat * flow_stress(law, 0.0, middle, rate, warmer)[0]
        stresses.append(flow_stress(law, 0.0, after, rate, temperature)[0])
        temperatures.append(temperature)
    return np.array(stresses), np.array(temperatures)


@pytest.mark.parametrize(
    ("rate", "start", "density", "capacity", "printed", "top"),
    [
        (1e4, 294.0, 8960.0, 383.0,
         "285.58 300.41 352.47 317.39 388.38 336.89 435.22 391.34 458.18 509.79", ("458.26", 1.933)),
        (4e3, 696.0, 8930.0, 414.0,
         "182.74 699.81 224.92 709.88 247.30 721.42 276.13 753.53 290.30 823.21", ("290.33", 1.949)),
    ],
)  # fmt: skip
def test_adiabatic_johnson_cook_curve(rate, start, density, capacity, printed, top):
    """Heated by its own plastic work at constant rate, copper follows the adiabatic curve to its largest stress."""
    stresses, temperatures = adiabatic(OFHC, rate, start, density, capacity, 2.0)
    values = printed.split()
    for strain, stress, kelvin in zip((0.1, 0.3, 0.5, 1.0, 2.0), values[::2], values[1::2], strict=True):
        row = round(strain * 4000) - 1
        assert_printed(stresses[row], stress)
        assert temperatures[row] == pytest.approx(float(kelvin), abs=0.0051)
    assert_printed(stresses.max(), top[0])
    assert (stresses.argmax() + 1) / 4000 == pytest.approx(top[1], abs=1e-3)


@pytest.mark.parametrize(
    ("law", "warmest", "strongest"),
    [(OFHC, 733.84, 261.977), (OFHC._replace(T_r=298.0, T_m=1793.0), 740.63, 311.715)],
    ids=["OFHC copper", "with Uintah's default temperatures"],
)
def test_adiabatic_johnson_cook_at_a_strain_of_seven_tenths(law, warmest, strongest):
    """At 4000 /s from 696 K, as for the other laws (test_rate_law_values)."""
    stresses, temperatures = adiabatic(law, 4e3, 696.0, 8930.0, 414.0, 0.7)
    assert temperatures[-1] == pytest.approx(warmest, abs=0.0051)
    assert stresses[-1] / 1e6 == pytest.approx(strongest, abs=0.0011)

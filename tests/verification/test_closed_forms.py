"""The closed forms against published tables and against the equations that they solve."""

import numpy as np
import pytest
from scipy.integrate import solve_bvp

from core_models.eos.mie_gruneisen import MieGruneisen
from studies.verification.closed_forms.conduction import cylinder, slab
from studies.verification.closed_forms.elastic_bodies import bar_period, spinning_disk
from studies.verification.closed_forms.elastica import tip_state
from studies.verification.closed_forms.plate_impact import elastic_limit, hydrodynamic_shock, shock_state

COPPER, SHEAR, FLOW_STRESS = MieGruneisen(8930.0, 3940.0, 2.02, 1.489), 45.45e9, 90e6

MATTIASSON = {
    0.5: (0.16214, 0.01592, 14.011),
    1.0: (0.30172, 0.05643, 26.434),
    2.0: (0.49346, 0.16064, 44.791),
    3.0: (0.60325, 0.25442, 56.495),
    5.0: (0.71379, 0.38763, 69.635),
    10.0: (0.81061, 0.55500, 81.949),
}
"""Load: deflection, shortening, angle in degrees. Mattiasson, Int. J. Num. Meth. Eng. 17 (1981) 145."""

HUGONIOT = {
    50.0: (4014.45, 1.7925e9, 9042.6),
    100.0: (4088.9, 3.6514e9, 9153.9),
    200.0: (4237.8, 7.5687e9, 9372.3),
    300.0: (4386.7, 11.752e9, 9585.5),
    500.0: (4684.5, 20.916e9, 9997.0),
    1000.0: (5429.0, 48.481e9, 10946.3),
}
WITH_STRENGTH = {
    100.0: (3.6834e9, 3.6234e9, 4096.1),
    200.0: (7.6000e9, 7.5400e9, 4244.6),
    300.0: (11.782e9, 11.722e9, 4393.2),
    500.0: (20.945e9, 20.885e9, 4690.6),
}


@pytest.mark.parametrize("load", MATTIASSON)
def test_elastica_has_the_published_tip(load):
    """Deflection, shortening and angle of the tip to the table's five digits."""
    found, expected = tip_state(load), MATTIASSON[load]
    assert found[:2] == pytest.approx(expected[:2], abs=6e-6)
    assert np.degrees(found.angle) == pytest.approx(expected[2], abs=6e-4)


def test_elastica_solves_its_differential_equation():
    """theta'' = - alpha cos theta, theta(0) = 0, theta'(1) = 0, by collocation."""
    load = 3.0
    arc = np.linspace(0.0, 1.0, 41)
    solved = solve_bvp(
        lambda s, y: np.vstack([y[1], -load * np.cos(y[0])]),
        lambda a, b: np.array([a[0], b[1]]),
        arc,
        np.vstack([arc, 1.0 - arc]),
        tol=1e-9,
    )
    fine = np.linspace(0.0, 1.0, 4001)
    angle = solved.sol(fine)[0]
    found = tip_state(load)
    assert found.angle == pytest.approx(angle[-1], abs=1e-7)
    assert found.deflection == pytest.approx(np.trapezoid(np.sin(angle), fine), abs=1e-7)
    assert found.shortening == pytest.approx(1.0 - np.trapezoid(np.cos(angle), fine), abs=1e-7)


@pytest.mark.parametrize("velocity", HUGONIOT)
def test_fluid_shock_has_the_tabulated_state(velocity):
    """Speed of the front, pressure and density of copper without strength, to the five digits of the table."""
    state = hydrodynamic_shock(COPPER, velocity)
    assert (state.front_speed, state.pressure, state.density) == pytest.approx(HUGONIOT[velocity], rel=5e-5)


@pytest.mark.parametrize("velocity", WITH_STRENGTH)
def test_plastic_shock_has_the_tabulated_state(velocity):
    """Axial stress, pressure and speed of the front of copper with constant strength, behind its precursor."""
    state = shock_state(COPPER, SHEAR, FLOW_STRESS, velocity)
    assert (state.stress, state.pressure, state.front_speed) == pytest.approx(
        WITH_STRENGTH[velocity], rel=5e-5
    )
    assert state.has_precursor


def test_elastic_limit_has_the_tabulated_state():
    """Hugoniot elastic limit 197.25 MPa at 4.677 m/s behind a front of 4723.3 m/s."""
    assert elastic_limit(COPPER, SHEAR, FLOW_STRESS) == pytest.approx((197.25e6, 4.677, 4723.3), rel=1.1e-4)


def test_strong_shock_outruns_its_precursor():
    """At 1,000 m/s there is one front, faster than elastic waves, close to the fluid's."""
    state = shock_state(COPPER, SHEAR, FLOW_STRESS, 1000.0)
    assert not state.has_precursor and state.front_speed > 4723.3
    assert state.stress == pytest.approx(COPPER.reference_density * state.front_speed * 1000.0, rel=1e-12)
    assert state.pressure == pytest.approx(HUGONIOT[1000.0][1], rel=2e-3)
    assert state.energy == pytest.approx(0.5e6, rel=1e-12)


def test_strength_vanishes_into_the_fluid():
    """With a flow stress of next to nothing the plastic shock is the fluid's."""
    weak = shock_state(COPPER, SHEAR, 1.0, 300.0)
    assert weak[:5] == pytest.approx(hydrodynamic_shock(COPPER, 300.0)[:5], rel=1e-4)


@pytest.mark.parametrize(("series", "power"), [(slab, 0), (cylinder, 1)], ids=["slab", "cylinder"])
def test_conduction_series_solve_the_heat_equation(series, power):
    """dT/dFo = x^-p d/dx (x^p dT/dx) inside, 0 on the surface, 1 everywhere at the start."""
    x, time, step = np.array([0.2, 0.5, 0.8]), 0.15, 1e-3
    rate = (series(x, time + step) - series(x, time - step)) / (2.0 * step)
    slope = (series(x + step, time) - series(x - step, time)) / (2.0 * step)
    curvature = (series(x + step, time) - 2.0 * series(x, time) + series(x - step, time)) / step**2
    assert np.allclose(rate, curvature + power * slope / x, atol=2e-4)
    assert series(np.array([1.0]), time) == pytest.approx(0.0, abs=1e-12)
    assert np.allclose(series(np.array([0.0, 0.3, 0.6]), 1e-3), 1.0, atol=1e-6)


def test_conduction_has_tabulated_centre_temperatures():
    """Centre of slab and cylinder at Fo = 0.2: 0.7723 and 0.5015 (Carslaw & Jaeger)."""
    assert slab(np.array([0.0]), 0.2) == pytest.approx(0.7723, abs=2e-4)
    assert cylinder(np.array([0.0]), 0.2) == pytest.approx(0.5015, abs=2e-4)


def test_bar_has_the_period_of_the_published_problem():
    """L = 25 m, E = 100 Pa, rho = 1 kg/m^3: 10 s."""
    assert bar_period(25.0, 100.0, 1.0) == pytest.approx(10.0)


def test_spinning_disk_is_in_balance_and_free_at_its_rim():
    """d s_r / dr + (s_r - s_t) / r = - rho w^2 r, Hooke's law in plane strain, s_r(R) = 0."""
    radius, spin, density, young, poisson = 0.5, 3.0, 1000.0, 1e6, 0.3
    r, step = np.array([0.1, 0.25, 0.4]), 1e-5
    displaced, radial, hoop = spinning_disk(r, radius, spin, density, young, poisson)
    ahead, behind = (spinning_disk(r + s, radius, spin, density, young, poisson) for s in (step, -step))
    slope = (ahead[1] - behind[1]) / (2.0 * step)
    assert np.allclose(slope + (radial - hoop) / r, -density * spin**2 * r, rtol=1e-8)
    strain = (ahead[0] - behind[0]) / (2.0 * step)
    axial = poisson * (radial + hoop)
    assert np.allclose(young * strain, radial - poisson * (hoop + axial), rtol=1e-6)
    assert np.allclose(young * displaced / r, hoop - poisson * (radial + axial), rtol=1e-12)
    assert spinning_disk(np.array([radius]), radius, spin, density, young, poisson)[1] == pytest.approx(0.0)

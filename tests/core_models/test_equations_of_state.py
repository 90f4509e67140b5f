"""Equations of state against worked values, identities and differences. Mean stress: tension positive."""

import numpy as np
import pytest

from core_models.driver import drive
from core_models.eos.default_hypo import DefaultHypoelastic
from core_models.eos.mie_gruneisen import MieGruneisen
from core_models.eos.neo_hookean import NeoHookean
from core_models.eos.spalling_mie_gruneisen import SpallingMieGruneisen
from core_models.errors import RunFailure
from core_models.laws import pressure
from core_models.paths import principal_stretches

COPPER = MieGruneisen(8930.0, 3940.0, 2.02, 1.489)
STIFFNESS = 8930.0 * 3940.0**2
SPALLING = SpallingMieGruneisen(*COPPER, 1.2e9)
EVERY_LAW = [COPPER, NeoHookean(136e9), DefaultHypoelastic(136e9), SPALLING]


@pytest.mark.parametrize(
    ("ratio", "printed"),
    [(0.99, -1.414053), (0.95, -7.682616), (0.9, -17.20451), (0.8, -44.86990), (1.01, 1.386257)],
)
def test_cold_curve_of_copper(ratio, printed):
    """Without energy the Mie-Grüneisen mean stress follows the worked values, also in tension."""
    assert pressure(COPPER, ratio, 0.0)[0] == pytest.approx(printed * 1e9, rel=1e-6)


@pytest.mark.parametrize(
    ("speed", "printed"),
    [(50, 1.7925), (100, 3.6514), (200, 7.5687), (300, 11.752), (500, 20.916), (1000, 48.481)],
)
def test_shock_states_lie_on_the_hugoniot(speed, printed):
    """With the energy that a shock brings the pressure is rho_0 U_s u_p, for any gamma."""
    shock = 3940.0 + 1.489 * speed
    ratio, energy = 1.0 - speed / shock, 0.5 * 8930.0 * speed**2
    for gamma in (2.02, 1.01):
        stress = pressure(COPPER._replace(Gamma_0=gamma), ratio, energy)[0]
        assert stress == pytest.approx(-8930.0 * shock * speed, rel=1e-12)
        assert stress == pytest.approx(-printed * 1e9, rel=1e-4)


@pytest.mark.parametrize("energy", [1e6, 5e9, -2e7])
def test_gamma_is_the_whole_of_grueneisens_gamma(energy):
    """At the reference volume p = -Gamma_0 e: not half or twice of it, which no Hugoniot would show."""
    assert pressure(COPPER, 1.0, energy)[0] == pytest.approx(-2.02 * energy, rel=1e-14)


def test_spall_cuts_tension_off_and_nothing_else():
    """Up to the spall strength bitwise Mie-Grüneisen, beyond it constant, by volume or by energy."""
    for ratio, energy in ((0.7, 1e9), (1.0, 0.0), (1.008, 0.0), (1.0, -5e8)):
        assert pressure(SPALLING, ratio, energy) == pressure(COPPER, ratio, energy)
    for ratio, energy in ((1.02, 0.0), (1.5, 1e8), (1.0, -1e9)):
        assert pressure(SPALLING, ratio, energy) == (1.2e9, 0.0, 0.0)


@pytest.mark.usefixtures("interpreted")
@pytest.mark.parametrize("update", ["hypo", "hyper"])
def test_a_body_pulled_apart_carries_its_spall_strength(copper, update):
    """Mean stress of uniaxial strain to J = 1.2 and back: never above the cut-off, at it while the body opens."""
    stretches = np.concatenate([np.linspace(1.0, 1.2, 41), np.linspace(1.2, 0.98, 45)])
    path = principal_stretches(stretches, np.ones_like(stretches), np.ones_like(stretches))
    mean = drive(copper(update, "perfect", eos=SPALLING), path, 1e-7).stress[:, :3].mean(axis=1)
    assert mean.max() == pytest.approx(1.2e9, rel=1e-6)
    assert mean[5:41] == pytest.approx(1.2e9, rel=1e-6)
    assert mean[-1] < 0.0


@pytest.mark.parametrize("law", EVERY_LAW, ids=lambda law: type(law).__name__)
@pytest.mark.parametrize("ratio", [0.6, 0.8, 0.95, 0.999, 1.001, 1.1, 1.6])
def test_slopes_are_derivatives(law, ratio):
    """Both slopes of every equation of state agree with central differences, on either side of J = 1."""
    step, energy = 1e-5, 3e8
    _stress, slope, by_energy = pressure(law, ratio, energy)
    above, below = (pressure(law, ratio + sign * step, energy)[0] for sign in (1, -1))
    assert slope == pytest.approx((above - below) / (2 * step), rel=1e-7)
    above, below = (pressure(law, ratio, energy + sign * 1e6)[0] for sign in (1, -1))
    assert by_energy == pytest.approx((above - below) / 2e6, rel=1e-7, abs=1e-9)


@pytest.mark.parametrize(("law", "bulk"), [(COPPER, STIFFNESS), (EVERY_LAW[1], 136e9), (EVERY_LAW[2], 136e9)])
def test_stiffness_at_rest_is_the_bulk_modulus(law, bulk):
    """No stress at rest, and the slope there is K, or rho_0 C_0^2."""
    assert pressure(law, 1.0, 0.0)[:2] == pytest.approx((0.0, bulk))


def test_neo_hookean_pressure_is_the_slope_of_its_stored_energy():
    """p = dU/dJ of U = K/2 [(J^2 - 1)/2 - ln J]."""
    ratio, step = np.linspace(0.5, 2.0, 31), 1e-5

    def stored(j):
        return 0.5 * 136e9 * (0.5 * (j**2 - 1.0) - np.log(j))

    slope = (stored(ratio + step) - stored(ratio - step)) / (2 * step)
    stress = [pressure(NeoHookean(136e9), j, 0.0)[0] for j in ratio]
    assert stress == pytest.approx(list(slope), rel=1e-7, abs=1e3)


def test_default_hypoelastic_pressure_sums_the_volume_rate():
    """p = K ln J: what dp/dt = K tr(d) gives along any path."""
    assert pressure(DefaultHypoelastic(136e9), 0.7, 0.0)[0] == pytest.approx(136e9 * np.log(0.7), rel=1e-14)


def test_compression_beyond_the_pole_is_refused(pool):
    """A step beyond J = 1 - 1/S_alpha ends the run with an error that says so, and never gives a stress."""
    pole = 1.0 - 1.0 / 1.489
    for ratio, fails in ((pole + 0.01, False), (pole - 0.01, True), (0.5 * pole, True)):
        path = principal_stretches(*np.array([[1.0, 1.0, 1.0], [ratio] * 3]).T ** (1.0 / 3.0)).round(12)
        if fails:
            with pytest.raises(RunFailure, match="pole of the equation of state"):
                drive(pool["hypo-jc-hot"], path, 1e-6)
        else:
            assert drive(pool["hypo-jc-hot"], path, 1e-6).stress[1, 0] < -1e12

"""Johnson-Cook flow stress."""

from typing import NamedTuple

from core_models.elementary import exponential, logarithm, power
from core_models.laws import flow_stress


class JohnsonCook(NamedTuple):
    """Johnson-Cook flow stress with the *plastic* strain rate, solved implicitly.

        sigma_y = (A + B ep^n) (1 + C ln max(rate / epdot_0, 1)) (1 - T*^m),   T* = (T - T_r) / (T_m - T_r) in [0, 1]

    Parameters
    ----------
    A, B : [Pa], A > 0. C, n, m : [-]. epdot_0 : reference rate [1/s], > 0. T_r, T_m : [K], T_m > T_r.

    Variant: that of the paper; continuous at the reference rate, no softening below T_r, zero strength at and above
    T_m. Uintah's code differs (total rate, (1 + rate)^C below epdot_0, T_r and T_m of its own): not offered.
    With n < 1 the slope is infinite at ep = 0: below ep = 1e-12 the hardening is a straight line.
    Source: Johnson & Cook, 7th Int. Symp. Ballistics (1983) 541.
    """

    A: float
    B: float
    C: float
    n: float
    m: float
    epdot_0: float
    T_r: float
    T_m: float

    uses_temperature = True


SMALLEST_STRAIN = 1e-12


@flow_stress.register(JohnsonCook)
def _(flow, hardening_variable, plastic_strain, plastic_rate, temperature):
    # Without branches, so that the loop over points takes several points per instruction.
    over_range = 1.0 / (flow.T_m - flow.T_r)
    homologous = min(max((temperature - flow.T_r) * over_range, 0.0), 1.0)
    softening = power(homologous, flow.m)
    thermal = 1.0 - softening
    thermal_slope = -flow.m * softening / max(homologous, SMALLEST_STRAIN) * over_range
    thermal_slope = thermal_slope if 0.0 < homologous < 1.0 else 0.0
    strain = max(plastic_strain, SMALLEST_STRAIN)
    secant = flow.B * exponential((flow.n - 1.0) * logarithm(strain))
    slope = secant if plastic_strain < SMALLEST_STRAIN else flow.n * secant
    static = flow.A + secant * plastic_strain
    rate = max(plastic_rate, flow.epdot_0)
    rate_factor = 1.0 + flow.C * logarithm(rate * (1.0 / flow.epdot_0))
    rate_slope = flow.C / rate if plastic_rate > flow.epdot_0 else 0.0
    return (
        static * thermal * rate_factor,
        0.0,
        slope * thermal * rate_factor,
        static * thermal * rate_slope,
        static * thermal_slope * rate_factor,
    )

"""Anand flow stress of hot metals and solders."""

import math
from typing import NamedTuple

from core_models.compilation import inside_kernel
from core_models.elementary import exponential, logarithm
from core_models.laws import evolve_hardening, flow_stress


class Anand(NamedTuple):
    """Anand's rate-dependent plasticity of hot metals, with the deformation resistance s as history variable.

        rate = A exp(-Q / (R T)) sinh(xi sigma_y / s)^(1/m)
        sigma_y = (s / xi) asinh(z^m),   z = (rate / A) exp(Q / (R T))
        ds / d ep = h_0 |1 - s / s*|^a sign(1 - s / s*),   s* = s_hat z^n,   s = s_0 at the start

    There is no yield surface: sigma_y is 0 at rate 0, and every stress flows.

    Parameters
    ----------
    s_0, h_0, s_hat : [Pa]. Q_over_R : [K]. A : [1/s]. xi, m, n : [-]. a : [-], >= 1.

    s follows its equation exactly over a step of constant rate and temperature. Below 1e-12 /s sigma_y is a straight
    line in the rate, and s* is that at 1e-12 /s.
    Source: Anand, Int. J. Plasticity 1 (1985) 213; Brown, Kim & Anand, Int. J. Plasticity 5 (1989) 95; constants of
    solders: Wang, Cheng, Becker & Wilde, J. Electron. Packag. 123 (2001) 247.
    """

    s_0: float
    Q_over_R: float
    A: float
    xi: float
    m: float
    h_0: float
    s_hat: float
    n: float
    a: float

    uses_temperature = True

    @property
    def hardening_variable(self) -> float:
        """Deformation resistance before any flow [Pa]."""
        return self.s_0


LOWEST_RATE = 1e-12  # 1/s
LOWEST_TEMPERATURE = 1.0  # K
LARGEST_EXPONENT = 300.0  # of z^m, so that its square is a number


@inside_kernel
def _logarithm_of_z(flow, rate, kelvin):
    return logarithm(rate / flow.A) + flow.Q_over_R / kelvin


@flow_stress.register(Anand)
def _(flow, hardening_variable, plastic_strain, plastic_rate, temperature):
    rate, kelvin = max(plastic_rate, LOWEST_RATE), max(temperature, LOWEST_TEMPERATURE)
    exponent = min(flow.m * _logarithm_of_z(flow, rate, kelvin), LARGEST_EXPONENT)
    ratio = exponential(exponent)
    share = math.asinh(ratio) / flow.xi
    is_free = exponent < LARGEST_EXPONENT
    by_exponent = ratio / math.sqrt(1.0 + ratio * ratio) / flow.xi if is_free else 0.0
    by_rate = flow.m * by_exponent / rate
    by_temperature = -flow.m * by_exponent * flow.Q_over_R / (kelvin * kelvin)
    is_straight = plastic_rate < LOWEST_RATE
    by_rate = share / rate if is_straight else by_rate
    by_temperature = by_temperature if temperature > LOWEST_TEMPERATURE else 0.0
    part = plastic_rate / rate if is_straight else 1.0
    return (
        hardening_variable * share * part,
        share * part,
        0.0,
        hardening_variable * by_rate,
        hardening_variable * by_temperature * part,
    )


@evolve_hardening.register(Anand)
def _(flow, hardening_variable, strain_increment, plastic_rate, temperature):
    """w = 1 - s / s* solves dw / d ep = -(h_0 / s*) |w|^a sign(w): w_1 = w_0 [1 + (a - 1) q]^(-1/(a - 1)),
    q = |w_0|^(a - 1) h_0 dep / s*.
    """
    rate, kelvin = max(plastic_rate, LOWEST_RATE), max(temperature, LOWEST_TEMPERATURE)
    target = flow.s_hat * exponential(flow.n * _logarithm_of_z(flow, rate, kelvin))
    distance = 1.0 - hardening_variable / target
    size = abs(distance)
    advance = flow.h_0 * strain_increment / target
    over = flow.a - 1.0
    slowness = size**over * advance
    exponent = slowness if over == 0.0 else math.log1p(over * slowness) / over
    decay = math.exp(-exponent)
    after = distance * decay
    slope = math.copysign(flow.h_0 * abs(after) ** flow.a, after)
    # In the cold s* is so far that s would be lost in s* (1 - w_1).
    growth = -target * distance * math.expm1(-exponent)
    by_log_target = growth - hardening_variable * math.expm1(-flow.a * exponent) - slope * strain_increment
    by_rate = by_log_target * flow.n / rate if plastic_rate > LOWEST_RATE else 0.0
    return hardening_variable + growth, slope, by_rate

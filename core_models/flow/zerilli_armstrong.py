"""Zerilli-Armstrong flow stress."""

import math
from typing import NamedTuple

from core_models.elementary import exponential, logarithm, power
from core_models.laws import flow_stress


class ZerilliArmstrong(NamedTuple):
    """Zerilli-Armstrong flow stress: thermally activated dislocation motion in bcc (B) and fcc (B_0) metals.

        sigma_y = sigma_g + k_H l^(-1/2) + K ep^n + B exp(-beta T) + B_0 sqrt(ep) exp(-alpha T)
        alpha = alpha_0 - alpha_1 ln(rate),   beta = beta_0 - beta_1 ln(rate),   both not below 0

    Parameters
    ----------
    sigma_g, B, B_0, K : [Pa]. k_H : [Pa m^0.5], sqrt_l_inv : l^(-1/2) of the grain size [m^-0.5], or both in other
    units of length. alpha_0, alpha_1, beta_0, beta_1 : [1/K]. n : [-], >= 0.

    Variant: plastic rate, not below 1e-8 /s; no strength is lost at melting (a melting law does that). With n < 1 and
    for the root the slope is infinite at ep = 0: below ep = 1e-12 the hardening is a straight line.
    Source: Zerilli & Armstrong, J. Appl. Phys. 61 (1987) 1816; Zerilli, Metall. Mater. Trans. A 35 (2004) 2547.
    """

    sigma_g: float
    k_H: float
    sqrt_l_inv: float
    B: float
    beta_0: float
    beta_1: float
    B_0: float
    alpha_0: float
    alpha_1: float
    K: float
    n: float

    uses_temperature = True


SMALLEST_STRAIN = 1e-12
LOWEST_RATE = 1e-8  # 1/s


@flow_stress.register(ZerilliArmstrong)
def _(flow, hardening_variable, plastic_strain, plastic_rate, temperature):
    # Without branches, so that the loop over points takes several points per instruction.
    rate = max(plastic_rate, LOWEST_RATE)
    over_rate = 1.0 / rate if plastic_rate > LOWEST_RATE else 0.0
    logarithm_of_rate = logarithm(rate)
    alpha = max(flow.alpha_0 - flow.alpha_1 * logarithm_of_rate, 0.0)
    beta = max(flow.beta_0 - flow.beta_1 * logarithm_of_rate, 0.0)
    alpha_1 = flow.alpha_1 if alpha > 0.0 else 0.0
    beta_1 = flow.beta_1 if beta > 0.0 else 0.0
    strain = max(plastic_strain, SMALLEST_STRAIN)
    straight = plastic_strain / strain
    peierls = flow.B * exponential(-beta * temperature)
    forest = flow.B_0 * math.sqrt(strain) * exponential(-alpha * temperature)
    hardening = flow.K * power(strain, flow.n)
    is_straight = plastic_strain < SMALLEST_STRAIN
    slope = (hardening + forest if is_straight else flow.n * hardening + 0.5 * forest) / strain
    stress = (
        flow.sigma_g
        + flow.k_H * flow.sqrt_l_inv
        + peierls
        + (hardening + forest) * (straight if is_straight else 1.0)
    )
    forest = forest * (straight if is_straight else 1.0)
    return (
        stress,
        0.0,
        slope,
        temperature * (beta_1 * peierls + alpha_1 * forest) * over_rate,
        -beta * peierls - alpha * forest,
    )

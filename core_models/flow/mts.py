"""Mechanical Threshold Stress flow law."""

import math
from typing import NamedTuple

from core_models.compilation import inside_kernel
from core_models.laws import evolve_hardening, flow_stress


class MechanicalThreshold(NamedTuple):
    """Mechanical Threshold Stress with the threshold stress as a true history variable.

        sigma_y = sigma_a + (S_i sigma_i + S_e sigma_e) mu(T) / mu_0
        S_x = [1 - (k T / (g_0x b^3 mu) ln(edot_0x / rate))^(1/q_x)]^(1/p_x),   x = e, i
        d sigma_e / d ep = theta_0 (1 - F) + theta_IV F,    F = tanh(alpha sigma_e / sigma_es) / tanh(alpha)
        theta_0 = a_0 + a_1 ln(rate) + a_2 sqrt(rate) - a_3 T
        sigma_es = sigma_es0 (rate / edot_es0)^(k T / (g_0es b^3 mu))
        mu(T) = b1 - b2 / (exp(b3 / T) - 1)

    Parameters
    ----------
    sigma_a, sigma_es0, theta_IV : [Pa]. koverbcubed : k/b^3 [Pa/K]. edot_0e, edot_es0 : [1/s].
    g_0e, g_0es, q_e, p_e, alpha : [-]. a_0 [Pa], a_1 [Pa], a_2 [Pa s^0.5], a_3 [Pa/K]. b1, b2 [Pa], b3 [K], mu_0 [Pa].
    sigma_i [Pa], g_0i, q_i, p_i [-], edot_0i [1/s] : the intrinsic barrier of bcc metals, which does not evolve; none
    with sigma_i = 0.

    Conventions: the rate is the plastic rate, not below 1e-7 /s; b1 (the 0 K modulus of mu) and mu_0 (the denominator)
    are kept apart; the elastic shear modulus is that of the slot shear_modulus. S_x is 0 where the bracket is
    negative and 1 above edot_0x; theta_0 and mu are not below 0.
    Source: Follansbee & Kocks, Acta Metall. 36 (1988) 81; Goto et al., Metall. Mater. Trans. A 31 (2000) 1985.
    """

    sigma_a: float
    koverbcubed: float
    edot_0e: float
    g_0e: float
    q_e: float
    p_e: float
    alpha: float
    edot_es0: float
    g_0es: float
    sigma_es0: float
    a_0: float
    a_1: float
    a_2: float
    a_3: float
    theta_IV: float
    b1: float
    b2: float
    b3: float
    mu_0: float
    sigma_i: float = 0.0
    g_0i: float = 0.0
    edot_0i: float = 0.0
    p_i: float = 0.0
    q_i: float = 0.0

    uses_temperature = True
    hardening_variable = 0.0

    def fault(self) -> str:
        """What is wrong with the parameters taken together; empty if nothing is."""
        if self.sigma_i > 0.0 and not all((self.g_0i, self.edot_0i, self.p_i, self.q_i)):
            return "a sigma_i needs g_0i, edot_0i, p_i and q_i above 0: give these, or none of the five"
        return ""


LOWEST_RATE = 1e-7  # 1/s
LOWEST_TEMPERATURE = 1.0  # K
LARGEST_SUBSTEP = 1e-3  # of plastic strain; the midpoint rule then errs by some 1e-6 of the threshold
MOST_SUBSTEPS = 2000.0  # so that strains that only an iteration tries take no longer than those of a step
LARGEST_EXPONENT = 20.0  # of sigma_es / sigma_es0 and of mu(T): far beyond it neither has a meaning


@inside_kernel
def _varshni_modulus(flow, temperature):
    exponent = min(flow.b3 / max(temperature, LOWEST_TEMPERATURE), LARGEST_EXPONENT)
    return max(flow.b1 - flow.b2 / math.expm1(exponent), 1e-6 * flow.b1)


@inside_kernel
def _thermal_factor(scale, reference_rate, q, p, rate):
    """S_x and its slope with respect to the rate; scale: k T / (g_0x b^3 mu)."""
    x = scale * math.log(reference_rate / rate)
    if x <= 0.0:
        return 1.0, 0.0
    y = x ** (1.0 / q)
    if y >= 1.0:
        return 0.0, 0.0
    s = (1.0 - y) ** (1.0 / p)
    return s, s / (p * (1.0 - y)) * y / (q * x) * scale / rate


@inside_kernel
def _evolving(flow, rate, temperature, mu):
    """S_e and its slope with respect to the rate."""
    scale = flow.koverbcubed * temperature / (flow.g_0e * mu)
    return _thermal_factor(scale, flow.edot_0e, flow.q_e, flow.p_e, rate)


@inside_kernel
def _intrinsic(flow, rate, temperature, mu):
    """S_i sigma_i and its slope with respect to the rate."""
    if flow.sigma_i == 0.0:
        return 0.0, 0.0
    scale = flow.koverbcubed * temperature / (flow.g_0i * mu)
    s, slope = _thermal_factor(scale, flow.edot_0i, flow.q_i, flow.p_i, rate)
    return s * flow.sigma_i, slope * flow.sigma_i


@inside_kernel
def _saturation(flow, rate, temperature, mu):
    """sigma_es and its relative slope with respect to the rate."""
    power = flow.koverbcubed * temperature / (flow.g_0es * mu)
    exponent = power * math.log(rate / flow.edot_es0)
    if abs(exponent) > LARGEST_EXPONENT:
        return flow.sigma_es0 * math.exp(math.copysign(LARGEST_EXPONENT, exponent)), 0.0
    return flow.sigma_es0 * math.exp(exponent), power / rate


@inside_kernel
def _initial_hardening(flow, rate, temperature):
    """theta_0 and its slope with respect to the rate."""
    root = math.sqrt(rate)
    theta_0 = flow.a_0 + flow.a_1 * math.log(rate) + flow.a_2 * root - flow.a_3 * temperature
    if theta_0 <= 0.0:
        return 0.0, 0.0
    return theta_0, flow.a_1 / rate + 0.5 * flow.a_2 / root


@inside_kernel
def _hardening_rate(flow, threshold, theta, saturation):
    """d sigma_e / d ep and its slopes with respect to threshold and rate; theta, saturation: each with its slope."""
    scale, top = flow.alpha / saturation[0], math.tanh(flow.alpha)
    t = math.tanh(scale * threshold)
    f = t / top
    slope = (flow.theta_IV - theta[0]) * scale * (1.0 - t * t) / top
    by_rate = theta[1] * (1.0 - f) - slope * threshold * saturation[1]
    return theta[0] * (1.0 - f) + flow.theta_IV * f, slope, by_rate


@flow_stress.register(MechanicalThreshold)
def _(flow, hardening_variable, plastic_strain, plastic_rate, temperature):
    rate = max(plastic_rate, LOWEST_RATE)
    mu = _varshni_modulus(flow, temperature)
    s, s_rate = _evolving(flow, rate, temperature, mu)
    barrier, barrier_rate = _intrinsic(flow, rate, temperature, mu)
    ratio = mu / flow.mu_0
    if plastic_rate <= LOWEST_RATE:
        s_rate, barrier_rate = 0.0, 0.0
    step = 1e-4 * max(temperature, LOWEST_TEMPERATURE)
    mu_hot = _varshni_modulus(flow, temperature + step)
    s_hot = _evolving(flow, rate, temperature + step, mu_hot)[0]
    barrier_hot = _intrinsic(flow, rate, temperature + step, mu_hot)[0]
    slope_temperature = hardening_variable * (s_hot * mu_hot / flow.mu_0 - s * ratio) / step
    return (
        flow.sigma_a + s * hardening_variable * ratio + barrier * ratio,
        s * ratio,
        0.0,
        s_rate * hardening_variable * ratio + barrier_rate * ratio,
        slope_temperature + (barrier_hot * mu_hot / flow.mu_0 - barrier * ratio) / step,
    )


@evolve_hardening.register(MechanicalThreshold)
def _(flow, hardening_variable, strain_increment, plastic_rate, temperature):
    """Midpoint rule, and along with it its sensitivities to increment and rate."""
    rate = max(plastic_rate, LOWEST_RATE)
    theta = _initial_hardening(flow, rate, temperature)
    saturation = _saturation(flow, rate, temperature, _varshni_modulus(flow, temperature))
    substeps = 1 + int(min(MOST_SUBSTEPS, strain_increment / LARGEST_SUBSTEP))
    share = 1.0 / substeps
    h = strain_increment * share
    threshold, by_increment, by_rate = hardening_variable, 0.0, 0.0
    for _substep in range(substeps):
        slope, slope_threshold, slope_rate = _hardening_rate(flow, threshold, theta, saturation)
        middle = threshold + 0.5 * h * slope
        middle_by_increment = by_increment + 0.5 * (share * slope + h * slope_threshold * by_increment)
        middle_by_rate = by_rate + 0.5 * h * (slope_threshold * by_rate + slope_rate)
        slope, slope_threshold, slope_rate = _hardening_rate(flow, middle, theta, saturation)
        threshold += h * slope
        by_increment += share * slope + h * slope_threshold * middle_by_increment
        by_rate += h * (slope_threshold * middle_by_rate + slope_rate)
        # Where recovery is faster than a substep resolves, the rule would go past 0, which the threshold cannot.
        if threshold < 0.0:
            threshold, by_increment, by_rate = 0.0, 0.0, 0.0
    if plastic_rate <= LOWEST_RATE:
        by_rate = 0.0
    return threshold, by_increment, by_rate

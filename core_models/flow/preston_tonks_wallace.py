"""Preston-Tonks-Wallace flow stress."""

import math
from typing import NamedTuple

from core_models.compilation import inside_kernel
from core_models.elementary import exponential, logarithm, power
from core_models.laws import flow_stress, under_pressure


class PrestonTonksWallace(NamedTuple):
    """Preston-Tonks-Wallace flow stress, from quasi-static rates to strong shocks.

        sigma_y = 2 tau mu,   tau = tau_s + A ln{1 - [1 - exp(-b)] exp[-theta ep / (A (exp(b) - 1))]}
        A = (s0 - tau_y) / p,   b = (tau_s - tau_y) / A
        tau_s = max{s0 - (s0 - sinf) erf(x), s0 (e / gamma)^beta}
        tau_y = max{y0 - (y0 - yinf) erf(x), min[y1 (e / gamma)^y2, s0 (e / gamma)^beta]}
        x = kappa (T / T_m) ln(gamma / e),   e = rate / xi,   xi = (4 pi rho / (3 M))^(1/3) (mu / rho)^(1/2) / 2
        mu = G0 [1 + slope P eta^(-1/3)] (1 - alphap T / T_m)

    with P > 0 in compression and eta = rho / rho_0: `flow_stress` is that at P = 0 and eta = 1, `under_pressure`
    gives the law elsewhere. p = 0 is the limit tau = tau_s - (tau_s - tau_y) exp[-theta ep / (tau_s - tau_y)].

    Parameters
    ----------
    theta, p, s0, sinf, kappa, gamma, y0, yinf, y1, y2, beta, alphap : [-]. M : atomic mass [u]. G0 : [Pa].
    slope_mu_p_over_mu0 : (dmu/dP) / G0 [1/Pa]. density : rho_0 [kg/m^3].
    melting_temperature : T_m [K].

    Variant: plastic rate, not below 1e-8 /s; x is not below 0; the branches (e / gamma)^... of the overdriven regime
    hold at every rate, as in the paper (Uintah: above 1e3 /s only); no strength at and above T_m.
    Source: Preston, Tonks & Wallace, J. Appl. Phys. 93 (2003) 211.
    """

    theta: float
    p: float
    s0: float
    sinf: float
    kappa: float
    gamma: float
    y0: float
    yinf: float
    y1: float
    y2: float
    beta: float
    M: float
    G0: float
    alphap: float
    slope_mu_p_over_mu0: float
    density: float
    melting_temperature: float

    uses_temperature = True


LOWEST_RATE = 1e-8  # 1/s
LOWEST_TEMPERATURE = 1.0  # K
ATOMIC_MASS = 1.66053906660e-27  # kg
SOFTEST = 1e-6  # of mu under tension or near melting, relative to G0
LARGEST_EXPONENT = 600.0  # b, so that exp(-b) is a number
SMALLEST_GAP = 1e-12  # of tau_s - tau_y: below it there is no hardening


@inside_kernel
def _limits(flow, e, x):
    """tau_s and tau_y, each with its slopes in ln(e) and in x."""
    barrier = math.erf(x)
    barrier_slope = 2.0 / math.sqrt(math.pi) * exponential(-x * x)
    drag = flow.s0 * power(e / flow.gamma, flow.beta)
    saturation = flow.s0 - (flow.s0 - flow.sinf) * barrier
    is_driven = drag > saturation
    s = drag if is_driven else saturation
    s_by_e = flow.beta * drag if is_driven else 0.0
    s_by_x = 0.0 if is_driven else -(flow.s0 - flow.sinf) * barrier_slope
    middle = flow.y1 * power(e / flow.gamma, flow.y2)
    driven_yield = min(middle, drag)
    driven_yield_slope = flow.y2 * middle if middle < drag else flow.beta * drag
    at_rest = flow.y0 - (flow.y0 - flow.yinf) * barrier
    is_driven = driven_yield > at_rest
    y = driven_yield if is_driven else at_rest
    y_by_e = driven_yield_slope if is_driven else 0.0
    y_by_x = 0.0 if is_driven else -(flow.y0 - flow.yinf) * barrier_slope
    return s, s_by_e, s_by_x, y, y_by_e, y_by_x


@inside_kernel
def _hardened(flow, s, y, strain):
    """tau between tau_y = y and tau_s = s at a strain, and its slopes in strain, s and y."""
    gap = s - y
    if gap <= SMALLEST_GAP:
        return s, 0.0, 1.0, 0.0
    scale = (flow.s0 - y) / flow.p if flow.p > 0.0 else 0.0
    if scale <= 0.0:
        k = flow.theta * strain / gap
        left = math.exp(-k)
        by_gap = -left * (1.0 + k)
        return s - gap * left, flow.theta * left, 1.0 + by_gap, -by_gap
    b = min(gap / scale, LARGEST_EXPONENT)
    u, rest = -math.expm1(-b), math.exp(-b)
    h = flow.theta * strain * rest / (scale * u)
    left = math.exp(-h)
    g = u * left
    one_minus_g = rest * left - math.expm1(-h)
    depth = math.log1p(-g) if g < 0.5 else math.log(one_minus_g)
    by_strain = flow.theta * rest * left / one_minus_g
    by_scale = depth - g * h / one_minus_g
    by_b = -scale * left * (rest + h) / one_minus_g
    by_y = -by_scale / flow.p + by_b * (b / flow.p - 1.0) / scale
    return s + scale * depth, by_strain, 1.0 + by_b / scale, by_y


@flow_stress.register(PrestonTonksWallace)
def _(flow, hardening_variable, plastic_strain, plastic_rate, temperature):
    if temperature >= flow.melting_temperature:
        return 0.0, 0.0, 0.0, 0.0, 0.0
    rate = max(plastic_rate, LOWEST_RATE)
    homologous = max(temperature, LOWEST_TEMPERATURE) / flow.melting_temperature
    softening = 1.0 - flow.alphap * homologous
    mu = flow.G0 * max(softening, SOFTEST)
    mu_by_t = -flow.G0 * flow.alphap / flow.melting_temperature if softening > SOFTEST else 0.0
    atoms = flow.density / (flow.M * ATOMIC_MASS)
    frequency = 0.5 * power(4.0 * math.pi / 3.0 * atoms, 1.0 / 3.0) * math.sqrt(mu / flow.density)
    e = rate / frequency
    height = logarithm(flow.gamma / e)
    x = max(flow.kappa * homologous * height, 0.0)
    s, s_by_e, s_by_x, y, y_by_e, y_by_x = _limits(flow, e, x)
    tau, by_strain, by_s, by_y = _hardened(flow, s, y, plastic_strain)
    by_e, by_x = by_s * s_by_e + by_y * y_by_e, by_s * s_by_x + by_y * y_by_x
    x_by_e = -flow.kappa * homologous if height > 0.0 else 0.0
    x_by_t = flow.kappa * height / flow.melting_temperature if height > 0.0 else 0.0
    by_e += by_x * x_by_e
    by_temperature = by_x * x_by_t - 0.5 * by_e * mu_by_t / mu
    by_rate = by_e / rate if plastic_rate > LOWEST_RATE else 0.0
    return (
        2.0 * tau * mu,
        0.0,
        2.0 * by_strain * mu,
        2.0 * by_rate * mu,
        2.0 * (by_temperature * mu + tau * mu_by_t),
    )


@under_pressure.register(PrestonTonksWallace)
def _(flow, density_ratio, pressure, melting):
    stiffening = 1.0 + flow.slope_mu_p_over_mu0 * pressure * power(density_ratio, -1.0 / 3.0)
    return PrestonTonksWallace(
        flow.theta, flow.p, flow.s0, flow.sinf, flow.kappa, flow.gamma, flow.y0, flow.yinf, flow.y1, flow.y2,
        flow.beta, flow.M, flow.G0 * max(stiffening, SOFTEST), flow.alphap, flow.slope_mu_p_over_mu0,
        flow.density * density_ratio, melting if melting < math.inf else flow.melting_temperature,
    )  # fmt: skip

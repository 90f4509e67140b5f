"""Shear modulus of Nadal and Le Poac."""

from typing import NamedTuple

from core_models.elementary import exponential, power
from core_models.laws import shear_modulus


class NadalLePoac(NamedTuple):
    """Shear modulus of Nadal and Le Poac, which falls to nothing in a narrow range above melting.

        G = {mu_0 [1 + slope P eta^(-1/3)] (1 - t) + rho k T / (C m)} / J(t),   t = T / T_m
        J(t) = 1 + exp{(t - 1) / (zeta [1 - t / (1 + zeta)])}

    P > 0 in compression, eta = rho / rho_0, T_m the melting temperature there.

    Parameters
    ----------
    mu_0 : modulus at 0 K and no pressure [Pa], > 0. zeta : width of the fall [-], > 0. slope_mu_p_over_mu0 :
    (dG/dP) / mu_0 [1/Pa]. C : (6 pi^2)^(2/3) f^2 / 3 of the Lindemann constant f [-], > 0. m : atomic mass [u].
    density : rho_0 [kg/m^3].

    G is not below 1e-6 mu_0, and is that from (1 + zeta) T_m on. The pressure bracket is not below 0.
    Source: Nadal & Le Poac, J. Appl. Phys. 93 (2003) 2472.
    """

    mu_0: float
    zeta: float
    slope_mu_p_over_mu0: float
    C: float
    m: float
    density: float

    uses_temperature = True


SOFTEST = 1e-6
LOWEST_MELTING = 1e-3  # K, of a body that tension has brought to melt at 0
BOLTZMANN = 1.380649e-23  # J/K
ATOMIC_MASS = 1.66053906660e-27  # kg


@shear_modulus.register(NadalLePoac)
def _(law, density_ratio, temperature, pressure, melting):
    melting = max(melting, LOWEST_MELTING)
    t = temperature / melting
    left = 1.0 + law.zeta - t
    is_solid = left > 0.0
    left = left if is_solid else 1.0
    growth = exponential((1.0 + law.zeta) * (t - 1.0) / (law.zeta * left)) if is_solid else 0.0
    over_j = 1.0 / (1.0 + growth)
    j_slope = growth * (1.0 + law.zeta) / (left * left)
    stretch = power(density_ratio, -1.0 / 3.0)
    stiffening = law.slope_mu_p_over_mu0 * pressure * stretch
    is_stiff = 1.0 + stiffening > 0.0
    lattice = law.mu_0 * max(1.0 + stiffening, 0.0)
    per_kelvin = law.density * density_ratio * BOLTZMANN / (law.C * law.m * ATOMIC_MASS)
    modulus = (lattice * (1.0 - t) + per_kelvin * temperature) * over_j
    is_free = is_solid and modulus > SOFTEST * law.mu_0
    by_t = -lattice * over_j - modulus * j_slope * over_j if is_free else 0.0
    by_stiffening = law.mu_0 * (1.0 - t) * over_j if is_free and is_stiff else 0.0
    thermal = per_kelvin * over_j if is_free else 0.0
    return (
        modulus if is_free else SOFTEST * law.mu_0,
        (thermal * temperature - by_stiffening * stiffening / 3.0) / density_ratio,
        by_t / melting + thermal,
        by_stiffening * law.slope_mu_p_over_mu0 * stretch,
        -by_t * t / melting,
    )

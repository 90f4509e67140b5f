"""Shear modulus of Preston, Tonks and Wallace."""

from typing import NamedTuple

from core_models.elementary import power
from core_models.laws import shear_modulus


class PrestonShearModulus(NamedTuple):
    """Shear modulus of Preston, Tonks and Wallace: G = mu_0 [1 + slope P eta^(-1/3)] (1 - alphap T / T_m).

    P > 0 in compression, eta = rho / rho_0, T_m the melting temperature there; no softening where nothing melts.

    Parameters
    ----------
    mu_0 : modulus at 0 K and no pressure [Pa], > 0. alphap : [-], >= 0. slope_mu_p_over_mu0 : (dG/dP) / mu_0 [1/Pa].

    Neither bracket is below 1e-6. Source: Preston, Tonks & Wallace, J. Appl. Phys. 93 (2003) 211, with the pressure
    term of Steinberg, Cochran and Guinan as in Uintah's `ptw_shear`.
    """

    mu_0: float
    alphap: float
    slope_mu_p_over_mu0: float

    uses_temperature = True


SOFTEST = 1e-6
LOWEST_MELTING = 1e-3  # K, of a body that tension has brought to melt at 0


@shear_modulus.register(PrestonShearModulus)
def _(law, density_ratio, temperature, pressure, melting):
    melting = max(melting, LOWEST_MELTING)
    stretch = power(density_ratio, -1.0 / 3.0)
    stiffening = law.slope_mu_p_over_mu0 * pressure * stretch
    cold = law.mu_0 * max(1.0 + stiffening, SOFTEST)
    hot = 1.0 - law.alphap * temperature / melting
    by_pressure = law.mu_0 * max(hot, SOFTEST) if 1.0 + stiffening > SOFTEST else 0.0
    by_temperature = -cold * law.alphap / melting if hot > SOFTEST else 0.0
    return (
        cold * max(hot, SOFTEST),
        -by_pressure * stiffening / (3.0 * density_ratio),
        by_temperature,
        by_pressure * law.slope_mu_p_over_mu0 * stretch,
        -by_temperature * temperature / melting,
    )

"""Shear modulus of Steinberg, Cochran and Guinan."""

from typing import NamedTuple

from core_models.elementary import power
from core_models.laws import shear_modulus


class SteinbergShearModulus(NamedTuple):
    """Shear modulus of Steinberg, Cochran and Guinan: G = mu_0 [1 + A P eta^(-1/3) - B (T - 300 K)].

    P > 0 in compression, eta = rho / rho_0.

    Parameters
    ----------
    mu_0 : modulus at 300 K and no pressure [Pa], > 0. A : (dG/dP) / mu_0 [1/Pa]. B : -(dG/dT) / mu_0 [1/K].

    G is not below 1e-6 mu_0, and is that from the melting temperature on.
    Source: Steinberg, Cochran & Guinan, J. Appl. Phys. 51 (1980) 1498; constants: Steinberg, UCRL-MA-106439 (1996).
    """

    mu_0: float
    A: float
    B: float

    uses_temperature = True


REFERENCE_TEMPERATURE = 300.0  # K
SOFTEST = 1e-6  # relative to mu_0


@shear_modulus.register(SteinbergShearModulus)
def _(law, density_ratio, temperature, pressure, melting):
    stretch = power(density_ratio, -1.0 / 3.0)
    stiffening = law.A * pressure * stretch
    ratio = 1.0 + stiffening - law.B * (temperature - REFERENCE_TEMPERATURE)
    is_free = ratio > SOFTEST and temperature < melting
    modulus = law.mu_0 if is_free else 0.0
    return (
        modulus * ratio if is_free else law.mu_0 * SOFTEST,
        -modulus * stiffening / (3.0 * density_ratio),
        -modulus * law.B,
        modulus * law.A * stretch,
        0.0,
    )

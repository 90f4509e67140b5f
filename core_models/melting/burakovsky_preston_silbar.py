"""Melting temperature of Burakovsky, Preston and Silbar."""

import math
from typing import NamedTuple

from core_models.elementary import logarithm, power
from core_models.laws import melting_temperature


class BurakovskyMelting(NamedTuple):
    """Melting temperature of dislocation-mediated melting; it grows with the pressure.

        T_m = T_m(0) [1/eta + eta^(-4/3) (G' / G_0) P],   eta = (1 + B' P / B_0)^(1/B')
        T_m(0) = kappa lambda G_0 v_WS / (8 pi ln(z - 1) k) ln[alpha^2 / (4 b^2 rho(T_m))],   v_WS = v_ws_a3_factor a^3

    with P > 0 in compression; the bracket of eta is not below 1e-3 under tension, T_m not below 0.

    Parameters
    ----------
    B0, G0 : bulk and shear modulus at no pressure [Pa]. dB_dp0, dG_dp0 : B', G' [-]. kappa : 1 for screw, 1/(1 - nu)
    for edge dislocations. z : coordination number [-], > 2. b2rhoTm : b^2 times the dislocation density at melting [-].
    alpha : core parameter [-]. lambda_ : b^3 / v_WS [-]. a : lattice constant [m]. v_ws_a3_factor : 1/4 for fcc, 1/2
    for bcc. Boltzmann_constant : k [J/K].

    Source: Burakovsky, Preston & Silbar, Phys. Rev. B 61 (2000) 15011; J. Appl. Phys. 88 (2000) 6294.
    """

    B0: float
    dB_dp0: float
    G0: float
    dG_dp0: float
    kappa: float
    z: float
    b2rhoTm: float
    alpha: float
    lambda_: float
    a: float
    v_ws_a3_factor: float
    Boltzmann_constant: float

    def fault(self) -> str:
        """What is wrong with the parameters taken together; empty if nothing is."""
        if self.alpha * self.alpha <= 4.0 * self.b2rhoTm:
            return "alpha^2 is not above 4 b2rhoTm, so that nothing melts above 0 K: correct one of them"
        return ""


SMALLEST_BRACKET = 1e-3


@melting_temperature.register(BurakovskyMelting)
def _(melting, density_ratio=1.0, pressure=0.0):
    volume = melting.v_ws_a3_factor * melting.a * melting.a * melting.a
    energy = (
        melting.kappa * melting.lambda_ * melting.G0 * volume / (8.0 * math.pi * logarithm(melting.z - 1.0))
    )
    dislocations = logarithm(melting.alpha * melting.alpha / (4.0 * melting.b2rhoTm))
    at_rest = energy / melting.Boltzmann_constant * dislocations
    bracket = max(1.0 + melting.dB_dp0 * pressure / melting.B0, SMALLEST_BRACKET)
    over_eta = power(bracket, -1.0 / melting.dB_dp0)
    stiffening = melting.dG_dp0 / melting.G0 * pressure
    return max(at_rest * over_eta * (1.0 + stiffening * power(over_eta, 1.0 / 3.0)), 0.0)

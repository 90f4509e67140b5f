"""Steinberg-Cochran-Guinan flow stress, with Lund's rate term on request."""

from typing import NamedTuple

from core_models.elementary import power
from core_models.flow.kink_pairs import kink_pair_stress
from core_models.laws import flow_stress, under_pressure
from core_models.melting.steinberg_cochran_guinan import lindemann_temperature


class SteinbergCochranGuinan(NamedTuple):
    """Steinberg-Cochran-Guinan flow stress, for high rates; with a Peierls stress Steinberg-Lund, for 1e-4 /s and up.

        sigma_y = {sigma_T + min(sigma_0 [1 + beta (ep + epsilon_p0)]^n, Y_max)} mu / mu_0
        mu / mu_0 = 1 + A P eta^(-1/3) - B (T - 300 K),   not below 0
        T_m = T_m0 exp[2 a (1 - 1/eta)] eta^(2 (Gamma_0 - a - 1/3)),   no strength at and above it
        rate = 1 / {exp[2 U_k (1 - sigma_T / sigma_P)^2 / (k T)] / C1 + C2 / sigma_T},   0 <= sigma_T <= sigma_P

    with P > 0 in compression and eta = rho / rho_0: `flow_stress` is that at P = 0 and eta = 1, `under_pressure`
    gives the law elsewhere.

    Parameters
    ----------
    sigma_0, Y_max : [Pa], 0 < sigma_0 <= Y_max. beta, n, epsilon_p0 : [-]. A : (dmu/dP) / mu_0 [1/Pa].
    B : -(dmu/dT) / mu_0 [1/K]. T_m0 : [K]. Gamma_0, a : [-].
    C1 [1/s], C2 [Pa s], energy_to_form_kink_pair U_k and Boltzmann_constant k (eV and eV/K), Peierls_stress sigma_P
    [Pa]: Lund's rate term; sigma_T = 0 without a Peierls stress.

    Variant: sigma_T solves its equation at every rate (Uintah cuts it to 0 below 1e-6 /s, where it is below 1 Pa).
    Source: Steinberg, Cochran & Guinan, J. Appl. Phys. 51 (1980) 1498; Steinberg & Lund, J. Appl. Phys. 65 (1989)
    1528; constants of metals: Steinberg, UCRL-MA-106439 (1996).
    """

    sigma_0: float
    beta: float
    n: float
    epsilon_p0: float
    Y_max: float
    A: float
    B: float
    T_m0: float
    Gamma_0: float
    a: float
    C1: float = 0.0
    C2: float = 0.0
    energy_to_form_kink_pair: float = 0.0
    Boltzmann_constant: float = 8.617333262e-5
    Peierls_stress: float = 0.0

    uses_temperature = True

    def fault(self) -> str:
        """What is wrong with the parameters taken together; empty if nothing is."""
        rate_term = (self.C1, self.C2, self.energy_to_form_kink_pair)
        if self.Peierls_stress > 0.0 and not all(rate_term):
            return "a Peierls_stress needs C1, C2 and energy_to_form_kink_pair above 0: give these, or none of the four"
        return ""


REFERENCE_TEMPERATURE = 300.0  # K, of mu_0
SOFTEST = 1e-6  # of mu under tension, relative to mu_0


@flow_stress.register(SteinbergCochranGuinan)
def _(flow, hardening_variable, plastic_strain, plastic_rate, temperature):
    base = 1.0 + flow.beta * (plastic_strain + flow.epsilon_p0)
    hardened = flow.sigma_0 * power(base, flow.n)
    slope = flow.n * flow.beta * hardened / base if hardened < flow.Y_max else 0.0
    thermal, by_rate, by_temperature = 0.0, 0.0, 0.0
    if flow.Peierls_stress > 0.0:
        thermal, by_rate, by_temperature = kink_pair_stress(flow, plastic_rate, temperature)
    is_solid = temperature < flow.T_m0
    ratio = max(1.0 - flow.B * (temperature - REFERENCE_TEMPERATURE), 0.0) if is_solid else 0.0
    strength = thermal + min(hardened, flow.Y_max)
    softening = strength * flow.B if ratio > 0.0 else 0.0
    return strength * ratio, 0.0, slope * ratio, by_rate * ratio, by_temperature * ratio - softening


@under_pressure.register(SteinbergCochranGuinan)
def _(flow, density_ratio, pressure, melting):
    # mu / mu_0 is the product of `stiffening` and of the same fall with temperature with B / stiffening
    stiffening = max(1.0 + flow.A * pressure * power(density_ratio, -1.0 / 3.0), SOFTEST)
    return SteinbergCochranGuinan(
        flow.sigma_0 * stiffening,
        flow.beta,
        flow.n,
        flow.epsilon_p0,
        flow.Y_max * stiffening,
        flow.A,
        flow.B / stiffening,
        lindemann_temperature(flow, density_ratio),
        flow.Gamma_0,
        flow.a,
        flow.C1,
        flow.C2 * stiffening,
        flow.energy_to_form_kink_pair,
        flow.Boltzmann_constant,
        flow.Peierls_stress * stiffening,
    )

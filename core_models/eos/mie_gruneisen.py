"""Mie-Grüneisen equation of state with a linear shock-particle velocity relation."""

from typing import NamedTuple

from core_models.elementary import exponential
from core_models.laws import is_beyond_eos, isentropic_ratio, pressure


class MieGruneisen(NamedTuple):
    """Mie-Grüneisen equation of state on the linear Hugoniot U_s = C_0 + S_alpha u_p.

    With h = 1 - J, mean stress p (tension positive) and energy e per *reference volume*:

        compression (h >= 0):  p = -[rho_0 C_0^2 h (1 - Gamma_0 h / 2) / (1 - S_alpha h)^2 + Gamma_0 e]
        tension     (h < 0):   p = -[rho_0 C_0^2 h + Gamma_0 e]

    Parameters
    ----------
    reference_density : rho_0 [kg/m^3], > 0. C_0 : bulk sound speed [m/s], > 0.
    Gamma_0 : the **full** Grüneisen gamma [-]; S_alpha : slope of the Hugoniot [-].

    Variant: the founding document's eq. (8) prints twice this gamma, but its card's Gamma_0 = 2.02 is copper's full
    gamma; this is the form of Uintah's code and later manual. Gamma/V is constant.
    Valid for h < 1/S_alpha; beyond that pole the point update returns the status BEYOND_EOS.
    Source: Wilkins, Computer Simulation of Dynamic Phenomena (1999); Zocher et al., ECCOMAS (2000).
    """

    reference_density: float
    C_0: float
    Gamma_0: float
    S_alpha: float

    uses_energy = True


@pressure.register(MieGruneisen)
def _(eos, volume_ratio, energy):
    h = 1.0 - volume_ratio
    stiffness = eos.reference_density * eos.C_0 * eos.C_0
    if h < 0.0:
        return -(stiffness * h + eos.Gamma_0 * energy), stiffness, -eos.Gamma_0
    d = 1.0 / (1.0 - eos.S_alpha * h)
    cold = stiffness * h * (1.0 - 0.5 * eos.Gamma_0 * h) * d * d
    slope = stiffness * (1.0 + (eos.S_alpha - eos.Gamma_0) * h) * d * d * d
    return -(cold + eos.Gamma_0 * energy), slope, -eos.Gamma_0


@isentropic_ratio.register(MieGruneisen)
def _(eos, before, after):
    return exponential(eos.Gamma_0 * (before - after))


@is_beyond_eos.register(MieGruneisen)
def _(eos, volume_ratio):
    return eos.S_alpha * (1.0 - volume_ratio) >= 0.999

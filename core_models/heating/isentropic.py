"""Heat from plastic work and from the change of volume."""

from typing import NamedTuple

from core_models.laws import heated_fraction, isentropic_ratio, volume_warming


class IsentropicHeating(NamedTuple):
    """Adiabatic heating by plastic work and by compression, and cooling by dilatation, at Mie and Grüneisen's gamma.

        dT = -T Gamma_0 dJ + fraction sigma_y dep / (rho_0 c)

    so that without plastic flow T = T_0 exp[Gamma_0 (1 - J)], the isentrope of Gamma rho = constant.

    Parameters
    ----------
    fraction : Taylor-Quinney coefficient [-], 0 < fraction <= 1 (0.9 for metals).

    Takes the Mie-Grüneisen equation of state. Source: Wilkins, Computer Simulation of Dynamic Phenomena (1999), sec. 3;
    Taylor & Quinney, Proc. R. Soc. Lond. A 143 (1934) 307.
    """

    fraction: float


@heated_fraction.register(IsentropicHeating)
def _(heating):
    return heating.fraction


@volume_warming.register(IsentropicHeating)
def _(heating, eos, before, after):
    return isentropic_ratio(eos, before, after)

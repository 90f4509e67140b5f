"""Heat from plastic work."""

from typing import NamedTuple

from core_models.laws import heated_fraction


class TaylorQuinney(NamedTuple):
    """Adiabatic plastic heating: rho_0 c dT = fraction sigma_y dep, per reference volume.

    Parameters
    ----------
    fraction : Taylor-Quinney coefficient [-], 0 <= fraction <= 1 (0.9 for metals).

    The return to the yield surface uses the temperature before the step. Heat from volume change is left out, the
    reversible (`IsentropicHeating` has it) as well as that of the bulk viscosity (Uintah's default); the energy of the
    equation of state has both.
    Source: Taylor & Quinney, Proc. R. Soc. Lond. A 143 (1934) 307.
    """

    fraction: float


@heated_fraction.register(TaylorQuinney)
def _(heating):
    return heating.fraction

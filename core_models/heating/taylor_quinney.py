"""Heat from plastic work."""

from typing import NamedTuple

from core_models.laws import generated_heat


class TaylorQuinney(NamedTuple):
    """Adiabatic plastic heating: rho_0 c dT = fraction sigma_y dep (per reference volume) + work of bulk viscosity.

    Parameters
    ----------
    fraction : Taylor-Quinney coefficient [-], 0 <= fraction <= 1 (0.9 for metals).

    The return to the yield surface uses the temperature before the step. Heat from elastic volume change is left out.
    Source: Taylor & Quinney, Proc. R. Soc. Lond. A 143 (1934) 307.
    """

    fraction: float


@generated_heat.register(TaylorQuinney)
def _(heating, dissipation, viscous_work):
    return heating.fraction * dissipation + viscous_work

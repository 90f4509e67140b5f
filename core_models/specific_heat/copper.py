"""Specific heat of copper."""

from typing import NamedTuple

from core_models.laws import heat_capacity


class CopperSpecificHeat(NamedTuple):
    """Specific heat of copper [J/(kg K)], from 15 K to melting.

        c = 4.16e-5 T^3 - 0.027 T^2 + 6.21 T - 142.6   below 270 K,   not below 1
        c = 0.1009 T + 358.4                           from 270 K on

    The pieces meet within 0.3 %. Source: Uintah's `copper_Cp`, a fit of measurements.
    """


WARM = 270.0  # K
LOWEST = 1.0  # J/(kg K)


@heat_capacity.register(CopperSpecificHeat)
def _(specific_heat, temperature):
    cold = ((4.16e-5 * temperature - 0.027) * temperature + 6.21) * temperature - 142.6
    return max(cold, LOWEST) if temperature < WARM else 0.1009 * temperature + 358.4

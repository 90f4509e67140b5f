"""Specific heat of iron and low-alloy steel."""

from typing import NamedTuple

from core_models.elementary import power
from core_models.laws import heat_capacity


class SteelSpecificHeat(NamedTuple):
    """Specific heat of iron and low-alloy steel [J/(kg K)] about the Curie point T_c = 1040 K, with t = T / T_c - 1.

        c = 190.14 - 273.75 |t| + 418.30 |t|^(-0.20)   below T_c
        c = 465.21 + 267.52 |t| +  58.16 |t|^(-0.35)   above

    Valid from some 290 K to 1800 K. Variant: |t| is not below 1e-3, where the formula goes to infinity.
    Source: Lederman, Salamon & Shacklette, Phys. Rev. B 9 (1974) 2981.
    """


CURIE_TEMPERATURE = 1040.0  # K
NEAREST = 1e-3


@heat_capacity.register(SteelSpecificHeat)
def _(specific_heat, temperature):
    t = max(abs(temperature / CURIE_TEMPERATURE - 1.0), NEAREST)
    below = 190.14 - 273.75 * t + 418.30 * power(t, -0.20)
    above = 465.21 + 267.52 * t + 58.16 * power(t, -0.35)
    return below if temperature < CURIE_TEMPERATURE else above

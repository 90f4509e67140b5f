"""Hancock-Mackenzie damage."""

from typing import NamedTuple

from core_models.elementary import exponential
from core_models.laws import damage_increment, strength_taken


class HancockMackenzieDamage(NamedTuple):
    """Hancock-Mackenzie damage, of voids that grow exponentially with triaxiality; it acts by `coupling` or erosion.

        d = initial_damage + sum dep exp(1.5 sigma_m / sigma_eq) / 1.65,   fails at d = critical_damage
        D = (d - initial_damage) / (critical_damage - initial_damage)

    D is what points carry: from 0, and 1 at failure. With 0 and 1 for the two parameters the failure strain is
    1.65 exp(-1.5 sigma_m / sigma_eq).

    Parameters
    ----------
    initial_damage, critical_damage : [-], 0 <= initial_damage < critical_damage. coupling : the flow stress is
    (1 - coupling D) of that of the flow law, with D up to 1 [-], in [0, 1].

    Variant: true triaxiality, in [-20/3, 20/3]; Uintah's critical damage does nothing there.
    Source: Hancock & Mackenzie, J. Mech. Phys. Solids 24 (1976) 147.
    """

    initial_damage: float
    critical_damage: float
    coupling: float = 0.0


STRAIN_SCALE = 1.65
LARGEST_EXPONENT = 10.0


@strength_taken.register(HancockMackenzieDamage)
def _(damage, value):
    return damage.coupling * min(value, 1.0)


@damage_increment.register(HancockMackenzieDamage)
def _(damage, strain_increment, plastic_rate, temperature, mean_stress, equivalent_stress):
    if strain_increment <= 0.0:
        return 0.0
    exponent = 0.0
    if equivalent_stress > 0.0:
        exponent = min(max(1.5 * mean_stress / equivalent_stress, -LARGEST_EXPONENT), LARGEST_EXPONENT)
    growth = strain_increment * exponential(exponent) / STRAIN_SCALE
    return growth / (damage.critical_damage - damage.initial_damage)

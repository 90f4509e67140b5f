"""Johnson-Cook damage."""

import math
from typing import NamedTuple

from core_models.elementary import exponential, logarithm
from core_models.laws import damage_increment, strength_taken


class JohnsonCookDamage(NamedTuple):
    """Johnson-Cook damage: D = sum dep / eps_f; it acts on the stress by `coupling` or through an erosion law.

        eps_f = [D1 + D2 exp(D3 s*)] [1 + D4 ln max(rate, 1)] [1 + D5 T*],   s* = sigma_m / sigma_eq in [-1.5, 1.5]

    with T* = (T - T_r) / (T_m - T_r) clamped to [0, 1] and the rate in 1/s.

    Parameters
    ----------
    D1 ... D5 : [-]. T_r, T_m : [K], T_m > T_r. coupling : the flow stress is (1 - coupling D) of that of the flow law,
    with D up to 1 [-], in [0, 1].

    Variant: plastic rate and true triaxiality; eps_f is not below 1e-3 (sets such as 6061-T6 turn negative at high
    triaxiality). Source: Johnson & Cook, Eng. Fract. Mech. 21 (1985) 31.
    """

    D1: float
    D2: float
    D3: float
    D4: float
    D5: float
    T_r: float
    T_m: float
    coupling: float = 0.0

    uses_temperature = True

    def caution(self) -> str:
        """What a user of these numbers should know; empty if nothing."""
        low, high = (
            self.D1 + self.D2 * exponential(self.D3 * s) for s in (-LARGEST_TRIAXIALITY, LARGEST_TRIAXIALITY)
        )
        if min(low, high) >= 0.0:
            return ""
        where = "at every triaxiality"
        if max(low, high) > 0.0:
            side = "above" if high < low else "below"
            where = f"{side} a triaxiality of {math.log(-self.D1 / self.D2) / self.D3:.4g}"
        return f"the failure strain turns negative {where}: there it is {SMALLEST_FAILURE_STRAIN:g}"


SMALLEST_FAILURE_STRAIN = 1e-3
LARGEST_TRIAXIALITY = 1.5


@strength_taken.register(JohnsonCookDamage)
def _(damage, value):
    return damage.coupling * min(value, 1.0)


@damage_increment.register(JohnsonCookDamage)
def _(damage, strain_increment, plastic_rate, temperature, mean_stress, equivalent_stress):
    if strain_increment <= 0.0:
        return 0.0
    triaxiality = 0.0
    if equivalent_stress > 0.0:
        triaxiality = min(max(mean_stress / equivalent_stress, -LARGEST_TRIAXIALITY), LARGEST_TRIAXIALITY)
    homologous = min(max((temperature - damage.T_r) / (damage.T_m - damage.T_r), 0.0), 1.0)
    failure_strain = (
        (damage.D1 + damage.D2 * exponential(damage.D3 * triaxiality))
        * (1.0 + damage.D4 * logarithm(max(plastic_rate, 1.0)))
        * (1.0 + damage.D5 * homologous)
    )
    return strain_increment / max(failure_strain, SMALLEST_FAILURE_STRAIN)

"""Isotropic thermal expansion with a constant coefficient."""

import math
from typing import NamedTuple

from core_models.laws import thermal_volume


class IsotropicExpansion(NamedTuple):
    """Isotropic thermal expansion: the pressure is that of the volume ratio J / J_th.

        J_th = exp(3 coefficient (T - T_0))

    Parameters
    ----------
    coefficient : of the length [1/K]. T_0 : temperature at which the undeformed body is free of stress [K].

    T is the temperature before the step. A body that starts at another temperature than T_0, and has its undeformed
    shape, is under pressure. No heat comes from it: thermoelastic cooling is left out.
    Source: Lu & Pister, Int. J. Solids Struct. 11 (1975) 927: the multiplicative split of thermal and elastic volume.
    """

    coefficient: float
    T_0: float

    uses_temperature = True


@thermal_volume.register(IsotropicExpansion)
def _(expansion, temperature):
    return math.exp(3.0 * expansion.coefficient * (temperature - expansion.T_0))

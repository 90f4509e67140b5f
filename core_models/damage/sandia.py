"""Sandia damage: growth of voids after Bammann, Chiesa and Johnson."""

import math
from typing import NamedTuple

from core_models.compilation import inside_kernel
from core_models.elementary import logarithm, power
from core_models.laws import damage_increment, strength_taken


class SandiaDamage(NamedTuple):
    """Sandia damage: voids that grow after Bammann, Chiesa and Johnson (Cocks and Ashby).

        d phi / d ep = [1 / (1 - phi)^m - (1 - phi)] sinh[2 (2 m - 1) / (2 m + 1) sigma_m / sigma_eq]
        D = H(phi) / H(critical_porosity),   H = ln{[1 - (1 - phi)^(m+1)] / [1 - (1 - initial_porosity)^(m+1)]}

    D is what points carry: from 0, and 1 at failure; dD = (m + 1) sinh[...] dep / H(critical_porosity) is the growth
    law itself, integrated. `porosity` gives phi.

    Parameters
    ----------
    m : exponent of the viscous matrix [-], > 1/2. initial_porosity, critical_porosity : volume fraction of voids [-],
    0 < initial_porosity < critical_porosity < 1. coupling : the flow stress is (1 - coupling D) of that of the flow
    law, with D up to 1 [-], in [0, 1]; D acts by it or through an erosion law.

    Variant: true triaxiality; voids do not shrink under pressure; the argument of sinh is at most 20. Sandia's LAME
    has the factor sqrt(2/3), its strain rate being the norm |D_p|.
    Source: Cocks & Ashby, Metal Sci. 14 (1980) 395; Bammann, Chiesa & Johnson, ICTAM (1996) 359.
    """

    m: float
    initial_porosity: float
    critical_porosity: float
    coupling: float = 0.0


LARGEST_ARGUMENT = 20.0


@inside_kernel
def void_growth(damage, porosity, triaxiality):
    """d phi / d ep [-] at a porosity and a triaxiality sigma_m / sigma_eq."""
    solid = 1.0 - porosity
    return (power(solid, -damage.m) - solid) * _growth_by_triaxiality(damage, triaxiality)


@inside_kernel
def porosity(damage, value):
    """Volume fraction of voids [-] where the damage variable has a value."""
    start = _void_measure(damage, damage.initial_porosity)
    end = _void_measure(damage, damage.critical_porosity)
    measure = start * math.exp(value * math.log(end / start))
    return 1.0 - max(1.0 - measure, 0.0) ** (1.0 / (damage.m + 1.0))


@inside_kernel
def _void_measure(damage, porosity):
    """1 - (1 - phi)^(m+1), which grows exponentially with the strain."""
    return 1.0 - power(1.0 - porosity, damage.m + 1.0)


@inside_kernel
def _growth_by_triaxiality(damage, triaxiality):
    argument = 2.0 * (2.0 * damage.m - 1.0) / (2.0 * damage.m + 1.0) * triaxiality
    argument = min(max(argument, 0.0), LARGEST_ARGUMENT)
    return math.sinh(argument)


@strength_taken.register(SandiaDamage)
def _(damage, value):
    return damage.coupling * min(value, 1.0)


@damage_increment.register(SandiaDamage)
def _(damage, strain_increment, plastic_rate, temperature, mean_stress, equivalent_stress):
    if strain_increment <= 0.0 or equivalent_stress <= 0.0:
        return 0.0
    start = _void_measure(damage, damage.initial_porosity)
    end = _void_measure(damage, damage.critical_porosity)
    growth = _growth_by_triaxiality(damage, mean_stress / equivalent_stress)
    return (damage.m + 1.0) * growth * strain_increment / logarithm(end / start)

"""Voids of a porous metal: how many there are at the start, and how many more plastic strain brings."""

import math
from typing import NamedTuple

from core_models.laws import damage_increment, nucleated

ROOT_2, ROOT_2_PI = math.sqrt(2.0), math.sqrt(2.0 * math.pi)


class VoidNucleation(NamedTuple):
    """Voids for the yield condition `Gurson`: some at the start, others where the strain of the matrix reaches them.

        d f = A d ep,   A = f_n / (s_n sqrt(2 pi)) exp[-((ep - eps_n) / s_n)^2 / 2]

    The integral is taken exactly. The damage variable is f* over the largest f* that `Gurson` knows.

    Parameters
    ----------
    initial_porosity : [-], 0 <= initial_porosity < 1. f_n : volume fraction of voids that nucleate [-], >= 0.
    eps_n : mean strain of nucleation [-]. s_n : its standard deviation [-], > 0.

    Source: Chu & Needleman, J. Eng. Mater. Technol. 102 (1980) 249.
    """

    initial_porosity: float
    f_n: float
    eps_n: float
    s_n: float

    @property
    def porosity_at_start(self) -> float:
        """Porosity of a point before any strain."""
        return self.initial_porosity


@nucleated.register(VoidNucleation)
def _(damage, plastic_strain, increment):
    before = (plastic_strain - damage.eps_n) / damage.s_n
    after = (plastic_strain + increment - damage.eps_n) / damage.s_n
    added = 0.5 * damage.f_n * (math.erf(after / ROOT_2) - math.erf(before / ROOT_2))
    return added, damage.f_n / (damage.s_n * ROOT_2_PI) * math.exp(-0.5 * after * after)


@damage_increment.register(VoidNucleation)
def _(damage, strain_increment, plastic_rate, temperature, mean_stress, equivalent_stress):
    return 0.0

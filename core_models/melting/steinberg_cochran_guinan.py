"""Melting temperature of Steinberg, Cochran and Guinan."""

from typing import NamedTuple

from core_models.compilation import inside_kernel
from core_models.elementary import exponential, logarithm
from core_models.laws import melting_temperature


class SteinbergMelting(NamedTuple):
    """Melting temperature of the modified Lindemann law; it grows with the density.

        T_m = T_m0 exp[2 a (1 - 1/eta)] eta^(2 (Gamma_0 - a - 1/3)),   eta = rho / rho_0

    Parameters
    ----------
    T_m0 : at the reference density [K], > 0. Gamma_0 : Grüneisen's gamma [-]. a : its fall with density [-].

    T_m0 belongs to this form: for copper it is 1790 K, while the metal melts at 1356 K under no pressure.
    Source: Steinberg, Cochran & Guinan, J. Appl. Phys. 51 (1980) 1498.
    """

    T_m0: float
    Gamma_0: float
    a: float


@inside_kernel
def lindemann_temperature(law, density_ratio):
    """T_m [K] of a law that holds T_m0, Gamma_0 and a, at a density ratio > 0."""
    exponent = 2.0 * (law.Gamma_0 - law.a - 1.0 / 3.0)
    return law.T_m0 * exponential(
        2.0 * law.a * (1.0 - 1.0 / density_ratio) + exponent * logarithm(density_ratio)
    )


@melting_temperature.register(SteinbergMelting)
def _(melting, density_ratio=1.0, pressure=0.0):
    return lindemann_temperature(melting, density_ratio)

"""Constant melting temperature."""

from typing import NamedTuple

from core_models.laws import melting_temperature


class ConstantMelting(NamedTuple):
    """Constant melting temperature: at and above it a point carries no deviatoric stress.

    Parameters
    ----------
    melting_temperature : T_m [K], > 0.
    """

    melting_temperature: float


@melting_temperature.register(ConstantMelting)
def _(melting, density_ratio=1.0, pressure=0.0):
    return melting.melting_temperature

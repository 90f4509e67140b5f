"""Constant specific heat."""

from typing import NamedTuple

from core_models.laws import heat_capacity


class ConstantSpecificHeat(NamedTuple):
    """Constant specific heat.

    Parameters
    ----------
    value : c [J/(kg K)], > 0.
    """

    value: float


@heat_capacity.register(ConstantSpecificHeat)
def _(specific_heat, temperature):
    return specific_heat.value

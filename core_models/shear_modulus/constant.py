"""Constant shear modulus."""

from typing import NamedTuple

from core_models.laws import shear_modulus


class ConstantShearModulus(NamedTuple):
    """Constant shear modulus.

    Parameters
    ----------
    value : G [Pa], > 0.
    """

    value: float


@shear_modulus.register(ConstantShearModulus)
def _(law, density_ratio, temperature, pressure, melting):
    return law.value, 0.0, 0.0, 0.0, 0.0

"""Voce hardening with a linear term."""

import math
from typing import NamedTuple

from core_models.laws import flow_stress


class Voce(NamedTuple):
    """Voce hardening with a linear term.

        sigma_y = yield_stress + (saturation_stress - yield_stress) (1 - exp(-saturation_rate ep)) + linear_modulus ep

    Parameters
    ----------
    yield_stress, saturation_stress : [Pa], > 0. saturation_rate : [-], >= 0. linear_modulus : [Pa].

    Source: Simo, Comput. Methods Appl. Mech. Eng. 99 (1992) 61 (necking bar: 0.45, 0.715 GPa, 16.93, 0.12924 GPa).
    """

    yield_stress: float
    saturation_stress: float
    saturation_rate: float
    linear_modulus: float


@flow_stress.register(Voce)
def _(flow, hardening_variable, plastic_strain, plastic_rate, temperature):
    gap = (flow.saturation_stress - flow.yield_stress) * math.exp(-flow.saturation_rate * plastic_strain)
    stress = flow.saturation_stress - gap + flow.linear_modulus * plastic_strain
    return stress, 0.0, flow.saturation_rate * gap + flow.linear_modulus, 0.0, 0.0

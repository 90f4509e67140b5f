"""Voce hardening with a linear term, softened linearly by heat."""

from typing import NamedTuple

from core_models.elementary import exponential
from core_models.laws import flow_stress


class ThermalVoce(NamedTuple):
    """Voce hardening with a linear term, softened linearly by heat.

        sigma_y = y + (Y - y) (1 - exp(-saturation_rate ep)) + H ep
        y = yield_stress [1 - yield_softening (T - T_0)]
        Y, H = saturation_stress, linear_modulus, each times [1 - hardening_softening (T - T_0)]

    Parameters
    ----------
    yield_stress, saturation_stress : [Pa], > 0. saturation_rate : [-], >= 0. linear_modulus : [Pa].
    yield_softening, hardening_softening : [1/K], >= 0. T_0 : temperature of the constants [K].

    The brackets are not below 0. Source: Simo & Miehe, Comput. Methods Appl. Mech. Eng. 98 (1992) 41; Armero & Simo,
    Int. J. Plasticity 9 (1993) 749 (necking bar: 0.45, 0.715 GPa, 16.93, 0.12924 GPa, both 0.002 /K, 293.15 K).
    """

    yield_stress: float
    saturation_stress: float
    saturation_rate: float
    linear_modulus: float
    yield_softening: float
    hardening_softening: float
    T_0: float

    uses_temperature = True


@flow_stress.register(ThermalVoce)
def _(flow, hardening_variable, plastic_strain, plastic_rate, temperature):
    warming = temperature - flow.T_0
    first = max(1.0 - flow.yield_softening * warming, 0.0)
    later = max(1.0 - flow.hardening_softening * warming, 0.0)
    first_slope = -flow.yield_softening if first > 0.0 else 0.0
    later_slope = -flow.hardening_softening if later > 0.0 else 0.0
    left = exponential(-flow.saturation_rate * plastic_strain)
    gap = (flow.saturation_stress * later - flow.yield_stress * first) * left
    growth = flow.saturation_stress + flow.linear_modulus * plastic_strain
    return (
        growth * later - gap,
        0.0,
        flow.saturation_rate * gap + flow.linear_modulus * later,
        0.0,
        growth * later_slope
        - (flow.saturation_stress * later_slope - flow.yield_stress * first_slope) * left,
    )

"""Kinematic hardening of Armstrong and Frederick."""

from typing import NamedTuple

from core_models.laws import back_stress_constants


class ArmstrongFrederick(NamedTuple):
    """Armstrong-Frederick: d alpha = 2/3 C d e_p - gamma alpha d ep; uniaxial saturation at C / gamma.

    Parameters
    ----------
    modulus : C [Pa], > 0. recovery : gamma [-], >= 0.

    Source: Armstrong & Frederick, CEGB report RD/B/N731 (1966), reprinted in Mater. High Temp. 24 (2007) 1.
    """

    modulus: float
    recovery: float


@back_stress_constants.register(ArmstrongFrederick)
def _(kinematic_hardening, term):
    return kinematic_hardening.modulus, kinematic_hardening.recovery

"""Ziegler's kinematic hardening."""

from typing import NamedTuple

from core_models.laws import back_stress_constants


class Ziegler(NamedTuple):
    """Ziegler: the yield surface moves along the radius to the stress, d alpha = C / sigma_y (s - alpha) d ep.

    sigma_y is the flow stress, the size of the surface.

    Parameters
    ----------
    modulus : C, the slope of the uniaxial stress by the plastic strain [Pa], > 0.

    With the von Mises condition d e_p = 3/2 (s - alpha) / sigma_y d ep: the path is that of Prager's law.
    Source: Ziegler, Q. Appl. Math. 17 (1959) 55.
    """

    modulus: float


@back_stress_constants.register(Ziegler)
def _(kinematic_hardening, term):
    return kinematic_hardening.modulus, 0.0

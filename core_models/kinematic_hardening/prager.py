"""Prager's linear kinematic hardening."""

from typing import NamedTuple

from core_models.laws import back_stress_constants


class Prager(NamedTuple):
    """Prager: the back stress follows the plastic strain, d alpha = 2/3 C d e_p; uniaxial: C times the plastic strain.

    Parameters
    ----------
    modulus : C, the slope of the uniaxial stress by the plastic strain [Pa], > 0.

    Source: Prager, J. Appl. Mech. 23 (1956) 493.
    """

    modulus: float


@back_stress_constants.register(Prager)
def _(kinematic_hardening, term):
    return kinematic_hardening.modulus, 0.0

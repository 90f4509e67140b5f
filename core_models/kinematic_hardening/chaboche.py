"""Chaboche's sum of back stresses."""

from typing import NamedTuple

from core_models.laws import back_stress_constants, back_stress_count
from core_models.rows import LARGEST_NUMBER_OF_BACK_STRESSES


class Chaboche(NamedTuple):
    """Chaboche: alpha = sum_i alpha_i, d alpha_i = 2/3 C_i d e_p - gamma_i alpha_i d ep.

    Parameters
    ----------
    moduli : C_i [Pa], > 0, two to four of them. recoveries : gamma_i [-], >= 0, as many.

    Kernels are compiled for each number of terms. Source: Chaboche, Int. J. Plast. 5 (1989) 247.
    """

    moduli: tuple[float, ...]
    recoveries: tuple[float, ...]

    def fault(self) -> str:
        """What is wrong with the parameters taken together; empty if nothing is."""
        if len(self.moduli) != len(self.recoveries):
            return (
                f"{len(self.moduli)} moduli and {len(self.recoveries)} recoveries: give one for each modulus"
            )
        if not 2 <= len(self.moduli) <= LARGEST_NUMBER_OF_BACK_STRESSES:
            return f"{len(self.moduli)} back stresses: give 2 to {LARGEST_NUMBER_OF_BACK_STRESSES}"
        return ""


@back_stress_count.register(Chaboche)
def _(kinematic_hardening):
    return len(kinematic_hardening.moduli)


@back_stress_constants.register(Chaboche)
def _(kinematic_hardening, term):
    return kinematic_hardening.moduli[term], kinematic_hardening.recoveries[term]

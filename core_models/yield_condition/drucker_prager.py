"""Drucker-Prager yield condition with dilation, apex and tension cut-off."""

import math
from typing import NamedTuple, Self

from core_models.errors import MaterialError
from core_models.names import suggestion

OVER_ROOT_3 = 1.0 / math.sqrt(3.0)
FITS = ("compression", "extension", "plane-strain")


class DruckerPrager(NamedTuple):
    """Drucker-Prager: sqrt(J_2) + alpha I_1 <= k, flow along sqrt(J_2) + beta I_1, mean stress <= tension_cutoff.

        k = cohesion_factor sigma_y
        d e_p = dgamma s / (2 sqrt(J_2)),   d v_p = 3 beta dgamma,   d ep = dgamma / sqrt(3)

    With kinematic hardening s is that beyond the back stress. sigma_y is the material's flow law: with cohesion_factor
    1 it gives k, with that of `from_friction` the cohesion c. At the apex m = k / (3 alpha), and at the cut-off, the
    volume grows as it must; at the apex d ep is not less than dv_p / (3 sqrt(3) alpha), which is conjugate to k in the
    plastic work. I_1 is the trace of the stress, positive in tension.

    Parameters
    ----------
    alpha : friction [-], >= 0, with a caution from 1 / sqrt(3) on, which is that of 90 degrees in compression. beta :
    dilation [-], 0 <= beta <= alpha. cohesion_factor : k / sigma_y [-], > 0. tension_cutoff : largest mean stress [Pa],
    > 0; infinite for none.

    Valid with every flow law; hardening and rate are those of the deviatoric plastic strain, at the apex also of the
    volume (core_models.yield_condition.apex).
    Source: Drucker & Prager, Q. Appl. Math. 10 (1952) 157; de Souza Neto, Peric & Owen, Computational Methods for
    Plasticity (2008), section 8.3 (return to cone and apex).
    """

    alpha: float
    beta: float
    cohesion_factor: float = 1.0
    tension_cutoff: float = math.inf

    has_plastic_volume = True

    @classmethod
    def from_friction(
        cls, friction: float, dilation: float, fit: str = "compression", tension_cutoff: float = math.inf
    ) -> Self:
        """The cone that meets Mohr-Coulomb's pyramid in triaxial compression or extension, or in plane strain.

        Parameters
        ----------
        friction, dilation : angles [degree], 0 <= dilation <= friction < 90. fit : 'compression', 'extension' or
        'plane-strain' (the associated failure load). tension_cutoff : [Pa].

        Raises MaterialError outside these ranges.
        """
        if not 0.0 <= dilation <= friction < 90.0:
            raise MaterialError(
                f"friction {friction!r} and dilation {dilation!r} degrees: give 0 <= dilation <= friction < 90"
            )
        if fit not in FITS:
            raise MaterialError(f"unknown fit '{fit}'; {suggestion(fit, FITS)}")
        alpha, factor = _matched(math.radians(friction), fit)
        beta, _factor = _matched(math.radians(dilation), fit)
        return cls(alpha, beta, factor, tension_cutoff)

    def fault(self) -> str:
        """What is wrong with the parameters taken together; empty if nothing is."""
        if self.beta > self.alpha:
            return (
                f"the dilation beta = {self.beta:g} is above the friction alpha = {self.alpha:g}, which would create "
                "energy: give beta <= alpha"
            )
        return ""

    def caution(self) -> str:
        """What a user of these numbers should know; empty if nothing."""
        if self.alpha < OVER_ROOT_3:
            return ""
        return (
            f"with alpha = {self.alpha:g}, not below 1 / sqrt(3) = 0.577, pressure in one direction never "
            "makes it yield: no friction angle is matched in compression"
        )


def _matched(angle: float, fit: str) -> tuple[float, float]:
    """alpha and k / c of a friction angle [rad]."""
    s, c = math.sin(angle), math.cos(angle)
    if fit == "plane-strain":
        root = math.sqrt(9.0 + 12.0 * math.tan(angle) ** 2)
        return math.tan(angle) / root, 3.0 / root
    side = 3.0 - s if fit == "compression" else 3.0 + s
    return 2.0 * s * OVER_ROOT_3 / side, 6.0 * c * OVER_ROOT_3 / side

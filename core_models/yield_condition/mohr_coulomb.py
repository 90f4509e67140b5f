"""Mohr-Coulomb yield condition with dilation, corners, apex and tension cut-off."""

import math
from typing import NamedTuple


class MohrCoulomb(NamedTuple):
    """Mohr-Coulomb: s_1 - s_3 + (s_1 + s_3) sin(friction) <= 2 c cos(friction), and s_1 <= tension_cutoff.

    Principal stresses s_1 >= s_2 >= s_3, positive in tension; c is the material's flow law. Flow on each plane follows
    the same expression with the angle of dilation, on the cut-off the normal; at edges the planes flow together, and at
    the apex s = c cot(friction) the volume grows as it must, and d ep is not less than dv_p (3 - sin) / (6 sin) of the
    friction. Friction 0 is Tresca's condition with sigma_y = 2 c.

    Parameters
    ----------
    friction_angle : [degree], 0 <= friction_angle < 90. dilation_angle : [degree], from 0 to the friction angle.
    tension_cutoff : largest principal stress [Pa], > 0; infinite for none.

    Valid with every flow law; hardening and rate are those of the deviatoric plastic strain, at the apex also of the
    volume (core_models.yield_condition.apex).
    Source: de Souza Neto, Peric & Owen, Computational Methods for Plasticity (2008), section 8.2.
    """

    friction_angle: float
    dilation_angle: float
    tension_cutoff: float = math.inf

    has_plastic_volume = True

    def fault(self) -> str:
        """What is wrong with the parameters taken together; empty if nothing is."""
        if self.dilation_angle > self.friction_angle:
            return (
                f"the dilation angle {self.dilation_angle:g} is above the friction angle {self.friction_angle:g}, "
                "which would create energy: give dilation_angle <= friction_angle"
            )
        return ""

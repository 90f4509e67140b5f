"""Power of the stress at the end of a step, while the body still moves as it has done in the step.

    P = sum_p V_p J (sigma - q 1) : L,   L = (F_1 - F_0) F_1^-1 / dt

The next step begins with the same forces, but on velocities that have gone to the particles and back: the difference
of their power is what that has cost besides kinetic energy.
"""

import numpy as np

from core_models.compilation import CHUNK, kernel
from core_models.points import MaterialPoints
from core_models.state import read
from core_models.tensors import determinant, inverse, load_tensor, product


@kernel
def add_powers(first, last, old, new, stress, viscous, volumes, powers):
    """Write dt P of the points of chunks first ... last-1 to powers (chunks,) [J].

    old, new : (n, 3, 3) F_0 and F_1. stress : (n, 6) [Pa]. viscous : (n,) [Pa] or None. volumes : (n,) reference [m^3].
    """
    for chunk in range(first, last):
        total = 0.0
        for p in range(chunk * CHUNK, min((chunk + 1) * CHUNK, volumes.shape[0])):
            f0, f1 = load_tensor(old, p), load_tensor(new, p)
            det, q = determinant(f1), read(viscous, p, 0.0)
            back = product(f0, inverse(f1, det))
            normal = (
                (stress[p, 0] - q) * (1.0 - back[0])
                + (stress[p, 1] - q) * (1.0 - back[4])
                + (stress[p, 2] - q) * (1.0 - back[8])
            )
            shear = (
                stress[p, 3] * (back[1] + back[3])
                + stress[p, 4] * (back[5] + back[7])
                + stress[p, 5] * (back[2] + back[6])
            )
            total += volumes[p] * det * (normal - shear)
        powers[chunk] = total


class StressPower:
    """Room for the sums over chunks of points."""

    def __init__(self, points: MaterialPoints) -> None:
        self._points, self._powers = points, np.zeros(-(-points.n // CHUNK))

    def over(self, dt: float) -> float:
        """P [W] of the state that has just been accepted after a step dt [s]."""
        points = self._points
        points.threads.run(
            add_powers, len(self._powers), points.deformation_gradient, points.old_deformation_gradient,
            points.old.stress, points.viscous_pressure, points.reference_volumes, self._powers,
        )  # fmt: skip
        return float(self._powers.sum()) / dt

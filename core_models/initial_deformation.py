"""How points come into a deformed initial state: slowly, and without being turned on the way."""

import numpy as np

from core_models.errors import SceneError
from core_models.points import MaterialPoints, PointFailure

STAGES = 16  # so that the energy stored is that of the path
QUASI_STATIC = 1e9  # s: time in which the deformation is imposed, so that no rate matters


def deform_slowly(points: MaterialPoints) -> tuple[float, float]:
    """Bring undeformed points to their `deformation_gradient` F = R U, through R [1 + s (U - 1)] for s up to 1.

    The rotation is there from the first stage on: on the straight way from 1 to F a turned body would be squeezed.
    Returns the energy stored and the energy dissipated plastically [J].
    Raises SceneError for a deformation that some point cannot have.
    """
    left, stretches, right = np.linalg.svd(points.deformation_gradient)
    rotations = left @ right
    change = right.swapaxes(1, 2) @ (stretches[:, :, None] * right) - np.eye(3)
    stored, dissipated = 0.0, 0.0
    for stage in range(1, STAGES + 1):
        points.deformation_gradient[:] = rotations @ (np.eye(3) + stage / STAGES * change)
        try:
            work = points.advance(QUASI_STATIC / STAGES)
        except PointFailure as reason:
            raise cannot_be(reason) from None
        points.accept()
        stored += work.stress - work.plastic
        dissipated += work.plastic
    if points.viscous_pressure is not None:
        points.viscous_pressure[:] = 0.0
    return stored, dissipated


def cannot_be(reason: PointFailure) -> SceneError:
    """The error for an initial displacement that some point cannot follow."""
    return SceneError(
        f"the initial displacement cannot be: {reason} at point {reason.point}: make it smaller"
    )

"""Symmetry planes of a body: flat boundaries normal to a coordinate axis."""

import numpy as np

from core_models.errors import SceneError
from core_models.geometry import AXES

FLAT = 1e-9  # largest departure of a symmetry boundary from its plane, as a part of the body's size


def symmetry_plane(mesh, name: str, names: str = AXES) -> tuple[int, float, int]:
    """Axis normal to a symmetry boundary, its coordinate [m], and the side of it on which the body lies (+1, -1).

    names : of the coordinates, for messages.
    Raises SceneError for a boundary that is not flat, not normal to an axis or has the body on both sides.
    """
    points = mesh.points[np.unique(mesh.boundaries[name])]
    size = float(np.ptp(mesh.points, axis=0).max())
    spread = np.ptp(points, axis=0)
    axis = int(spread.argmin())
    if spread[axis] > FLAT * size:
        raise SceneError(
            f"Symmetry on {name!r}: its nodes spread over {spread[axis]:.3g} m along {names[axis]}: "
            "a symmetry boundary is a plane normal to a coordinate axis"
        )
    position = float(points[:, axis].mean())
    low, high = mesh.points[:, axis].min() - position, mesh.points[:, axis].max() - position
    if low < -FLAT * size and high > FLAT * size:
        raise SceneError(
            f"Symmetry on {name!r}: the body reaches from {low:.3g} to {high:.3g} m on both sides of the plane "
            f"{names[axis]} = {position:.6g} m: mesh only one side"
        )
    return axis, position, 1 if high > FLAT * size else -1

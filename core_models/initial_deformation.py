"""How points come into a deformed initial state: slowly, and without being turned on the way."""

from collections.abc import Callable

import numpy as np

from core_models.agreement import mirrored_motions
from core_models.errors import SceneError
from core_models.geometry import Axisymmetric, Geometry, axis_names
from core_models.initial_motion import field_values
from core_models.loads import Load
from core_models.points import MaterialPoints, PointFailure
from core_models.symmetry import FLAT
from core_models.walls import Wall, check_above

STAGES = 16  # so that the energy stored is that of the path
QUASI_STATIC = 1e9  # s: time in which the deformation is imposed, so that no rate matters


def check_displacement(
    displacement: Callable | None, mesh, geometry: Geometry, loads: tuple[Load, ...], wall: Wall | None
) -> None:
    """Refuse an initial displacement off the axis or a symmetry plane, across the axis, or into the wall.

    displacement : function of positions (n, d) [m], or None.
    Raises SceneError naming the node, or the part of the body below the wall.
    """
    if displacement is None:
        return
    moves = field_values("displacement", displacement, mesh.points, "m")
    names, size = axis_names(geometry), float(np.ptp(mesh.points, axis=0).max())
    for plane in mirrored_motions(loads, mesh, geometry):
        away = moves[plane.nodes, plane.component]
        off = np.abs(away) > FLAT * size
        if off.any():
            node = plane.nodes[int(off.argmax())]
            place = ", ".join(f"{x:.6g}" for x in mesh.points[node])
            raise SceneError(
                f"the initial displacement moves node {node} ({place}) m of {plane.boundary!r} by "
                f"{away[int(off.argmax())]:.6g} m along {names[plane.component]}, but a plane of symmetry stays where "
                "it is: give 0 there"
            )
    places = mesh.points + moves
    if isinstance(geometry, Axisymmetric) and places[:, 0].min() < -FLAT * size:
        raise SceneError(
            f"the initial displacement puts node {int(places[:, 0].argmin())} at r = {places[:, 0].min():.6g} m: "
            "give one that leaves the body at r >= 0"
        )
    check_above(wall, places, geometry)


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

"""A disk without a degenerate element at its centre."""

from collections.abc import Sequence

import numpy as np

from core_models.errors import MeshError
from meshes.butterfly import quarter_disk
from meshes.kinds import find_kind
from meshes.mesh import Mesh
from meshes.parameters import check_length, check_point, check_total
from meshes.patch import Patch, weld


def disk(radius: float, size: float, kind: str = "quad4", centre: Sequence[float] = (0.0, 0.0)) -> Mesh:
    """A disk |x - centre| <= radius: a square core and four patches from it to the circle.

    radius, size [m] : of the disk and of its elements along the axes, of which a whole number, at least 2, is taken
    on the radius. kind : of the elements, 2-D; middle nodes lie on the circle. Boundary: outer.
    Raises MeshError when a parameter is outside its range.
    """
    find_kind(kind, 2)
    check_length("disk", "radius", radius)
    check_length("disk", "size", size)
    check_total("disk", 3.0 * (radius / size) ** 2)
    if size > radius:
        raise MeshError(f"disk: size is {size:g}, the radius {radius:g}; give a smaller size")
    middle = check_point("disk", "centre", centre, 2)
    quarter = [patch.renamed(_outer_of(patch)) for patch in quarter_disk(max(2, round(radius / size)), kind)]
    whole = weld(
        [patch.mapped(lambda x, turns=turns: _turned(x, turns)) for turns in range(4) for patch in quarter]
    )
    points = radius * whole.points + middle
    return Mesh(points, kind, whole.cells, whole.boundaries, source="disk")


def _outer_of(patch: Patch) -> dict[str, str]:
    return {name: name for name in patch.boundaries if name == "outer"}


def _turned(points: np.ndarray, turns: int) -> np.ndarray:
    """Points (n, 2) turned by so many right angles, without round-off."""
    x, y = points.T
    return np.column_stack([(x, y), (-y, x), (-x, -y), (y, -x)][turns])

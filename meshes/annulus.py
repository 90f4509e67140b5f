"""A ring between two circles, whole or a quarter of it."""

from collections.abc import Sequence
from math import pi

import numpy as np

from core_models.errors import MeshError
from meshes.kinds import find_kind
from meshes.mesh import Mesh
from meshes.parameters import check_count, check_counts, check_length, check_number, check_point
from meshes.patch import even_patch, weld


def annulus(
    inner: float,
    outer: float,
    counts: Sequence[int],
    kind: str = "quad4",
    quarter: bool = False,
    centre: Sequence[float] = (0.0, 0.0),
) -> Mesh:
    """A ring inner <= |x - centre| <= outer, or its quarter x, y >= centre.

    inner, outer : radii [m]. counts : parts along the radius and around (of the whole ring at least 3; of a quarter,
    along its arc). kind : of the elements, 2-D; a part is a quad or two triangles, with middle nodes on the circles.
    Boundaries: inner, outer; of a quarter also symmetry_x (x = centre) and symmetry_y (y = centre).
    Raises MeshError when a parameter is outside its range.
    """
    find_kind(kind, 2)
    check_length("annulus", "inner", inner)
    check_number("annulus", "outer", outer)
    if not outer > inner:
        raise MeshError(f"annulus: outer is {outer:g}, inner {inner:g}; give an outer radius above the inner")
    middle = check_point("annulus", "centre", centre, 2)
    parts = check_counts("annulus", counts, kind)
    if not quarter:
        check_count("annulus", "counts around", int(parts[1]), 3)
    patch = even_patch(parts, kind)
    names = {"left": "inner", "right": "outer"}
    if quarter:
        patch = patch.renamed(names | {"bottom": "symmetry_y", "top": "symmetry_x"})
        patch = patch.mapped(lambda x: _arc(inner, outer, x, 0.5 * pi))
        patch.points[np.abs(patch.points) < 1e-12 * outer] = 0.0
    else:
        patch = weld([patch.renamed(names).mapped(lambda x: _arc(inner, outer, x, 2.0 * pi))])
    return Mesh(patch.points + middle, kind, patch.cells, patch.boundaries, source="annulus")


def _arc(inner: float, outer: float, unit: np.ndarray, angle: float) -> np.ndarray:
    """Points of the unit square on an arc: the first coordinate along the radius, the second around."""
    radius = inner * (1.0 - unit[:, 0]) + outer * unit[:, 0]
    return radius[:, None] * np.column_stack([np.cos(angle * unit[:, 1]), np.sin(angle * unit[:, 1])])

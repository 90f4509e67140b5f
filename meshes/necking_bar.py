"""The tension bar that necks: half of its length, as a body of revolution or as a quarter of the section in 3-D."""

from dataclasses import replace

import numpy as np

from core_models.errors import MeshError
from meshes.kinds import find_kind
from meshes.mesh import Mesh
from meshes.taylor_bar import taylor_bar
from meshes.taylor_quarter import taylor_quarter

SMALLEST_TAPER = 0.5


def necking_bar(
    radius: float,
    length: float,
    elements_across: int,
    elements_along: int | None = None,
    taper: float = 0.982,
    grading: float = 1.0,
    kind: str = "quad4",
) -> Mesh:
    """Mesh the upper half of a bar whose radius grows linearly from the neck to the end:

        R(z) = radius (taper + (1 - taper) z / length),  0 <= z <= length

    Parameters: radius: at the end [m], > 0; length: half of the bar [m], > 0; elements_across, elements_along: as
    `meshes.taylor_bar` and, in 3-D, `meshes.taylor_quarter` take them; taper: radius at the neck over that at the end,
    0.5 to 1; grading: height of the elements at the neck divided by that at the end, 0.01 to 100; kind: of the
    elements: 2-D for the section (r, z), 3-D for the eighth x, y, z >= 0.
    Boundaries: neck (z = 0), side, end, and axis, or symmetry_x (x = 0) and symmetry_y (y = 0).
    Raises MeshError when a parameter is outside its range or gmsh cannot be loaded.
    Source: the taper of 0.982 that starts the neck: Simo, Comput. Methods Appl. Mech. Eng. 99 (1992) 61.
    """
    if not SMALLEST_TAPER <= taper <= 1.0:
        raise MeshError(f"necking bar: taper is {taper:g}; give a number from {SMALLEST_TAPER} to 1")
    make = taylor_bar if find_kind(kind).dimension == 2 else taylor_quarter
    bar = make(radius, length, elements_across, elements_along, grading=grading, kind=kind)
    points = bar.points.copy()
    points[:, :-1] *= (taper + (1.0 - taper) * points[:, -1] / length)[:, None]
    names = {"foot": "neck", "rear": "end"}
    boundaries = {names.get(name, name): facets for name, facets in bar.boundaries.items()}
    return replace(bar, points=np.ascontiguousarray(points), boundaries=boundaries, source="necking bar")

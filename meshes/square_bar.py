"""An eighth of a bar of square section that is pulled."""

from dataclasses import replace

import numpy as np

from core_models.errors import MeshError
from meshes.block import block
from meshes.kinds import find_kind
from meshes.mesh import Mesh
from meshes.necking_bar import SMALLEST_TAPER
from meshes.parameters import check_grading
from meshes.progression import progression

NAMES = {
    "left": "symmetry_x", "right": "side", "front": "symmetry_y", "back": "side_y", "bottom": "neck", "top": "end"
}  # fmt: skip


def square_bar(
    width: float,
    length: float,
    elements_across: int,
    elements_along: int,
    taper: float = 1.0,
    grading: float = 1.0,
    kind: str = "hex8",
) -> Mesh:
    """Mesh the eighth x, y, z >= 0 of a bar whose half width grows linearly from the neck to the end:

        B(z) = width (taper + (1 - taper) z / length),  0 <= z <= length

    Parameters: width, length: half of the bar's [m], > 0; elements_across: along each side, elements_along: >= 1;
    taper: width at the neck over that at the end, 0.5 to 1; grading: height of the elements at the neck divided by that
    at the end, 0.01 to 100; kind: of the elements, 3-D.
    Boundaries: symmetry_x (x = 0), symmetry_y (y = 0), neck (z = 0), side (x = B), side_y (y = B), end.
    Raises MeshError when a parameter is outside its range.
    """
    find_kind(kind, 3)
    if not SMALLEST_TAPER <= taper <= 1.0:
        raise MeshError(f"square bar: taper is {taper:g}; give a number from {SMALLEST_TAPER} to 1")
    check_grading("square bar", grading)
    mesh = block([0.0] * 3, [width, width, length], [elements_across, elements_across, elements_along], kind)
    points = mesh.points.copy()
    points[:, 2] = length * progression(points[:, 2] / length, elements_along, grading)
    points[:, :2] *= (taper + (1.0 - taper) * points[:, 2] / length)[:, None]
    boundaries = {NAMES[name]: facets for name, facets in mesh.boundaries.items()}
    return replace(mesh, points=np.ascontiguousarray(points), boundaries=boundaries, source="square bar")

"""A quarter of a strip that is pulled in plane strain."""

from dataclasses import replace

from core_models.errors import MeshError
from meshes.block import block
from meshes.kinds import find_kind
from meshes.mesh import Mesh
from meshes.necking_bar import SMALLEST_TAPER

NAMES = {"left": "symmetry", "right": "side", "bottom": "neck", "top": "end"}


def tension_strip(
    width: float,
    length: float,
    elements_across: int,
    elements_along: int,
    taper: float = 1.0,
    kind: str = "quad4",
) -> Mesh:
    """Mesh the quarter x, y >= 0 of a strip whose half width grows linearly from the neck to the end:

        B(y) = width (taper + (1 - taper) y / length),  0 <= y <= length

    Parameters: width, length: half of the strip's [m], > 0; elements_across, elements_along: >= 1; taper: width at the
    neck over that at the end, 0.5 to 1; kind: of the elements, 2-D.
    Boundaries: symmetry (x = 0), neck (y = 0), side, end.
    Raises MeshError when a parameter is outside its range.
    """
    find_kind(kind, 2)
    if not SMALLEST_TAPER <= taper <= 1.0:
        raise MeshError(f"tension strip: taper is {taper:g}; give a number from {SMALLEST_TAPER} to 1")
    mesh = block([0.0, 0.0], [width, length], [elements_across, elements_along], kind)
    points = mesh.points.copy()
    points[:, 0] *= taper + (1.0 - taper) * points[:, 1] / length
    boundaries = {NAMES[name]: facets for name, facets in mesh.boundaries.items()}
    return replace(mesh, points=points, boundaries=boundaries, source="tension strip")

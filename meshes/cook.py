"""Cook's membrane: a tapered panel, held at one end and sheared at the other, that shows locking."""

from collections.abc import Sequence

from core_models.errors import MeshError
from meshes.kinds import find_kind
from meshes.mesh import Mesh
from meshes.parameters import check_counts, check_length
from meshes.patch import even_patch

LENGTH, HEIGHT, END = 48.0, 44.0, 16.0
"""Of the panel, and the height of its free end, in units; its upper edge rises as much as the free end's height."""


def cook(
    counts: Sequence[int], kind: str = "quad4", unit: float = 1e-3, thickness: float | None = None
) -> Mesh:
    """Cook's membrane with corners (0, 0), (48, 44), (48, 60), (0, 44) units.

    counts : parts along each coordinate. kind : of the elements; of 3-D ones the panel lies in the (x, z) plane.
    unit : [m]. thickness : of the panel along y, 3-D only, in units (default: 1).
    Boundaries: left (the held end), right (the sheared end), bottom, top, in 3-D also front, back.
    Raises MeshError when a parameter is outside its range. Source: R. D. Cook, J. Struct. Div. 100 (1974) 1851.
    """
    check_length("cook", "unit", unit)
    if thickness is not None and find_kind(kind).dimension == 2:
        raise MeshError(f"cook: thickness is for 3-D elements; leave it out for {kind}")
    depth = 1.0 if thickness is None else thickness
    check_length("cook", "thickness", depth)
    patch = even_patch(check_counts("cook", counts, kind), kind)
    points = patch.points.copy()
    s, t = points[:, 0].copy(), points[:, -1].copy()
    points[:, 0] = LENGTH * s
    points[:, 1] *= depth
    points[:, -1] = HEIGHT * s + t * (HEIGHT + s * (END - HEIGHT))
    return Mesh(unit * points, kind, patch.cells, patch.boundaries, source="cook")

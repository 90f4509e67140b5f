"""A straight beam along x."""

from collections.abc import Sequence

from meshes.block import block
from meshes.kinds import find_kind
from meshes.mesh import Mesh
from meshes.parameters import check_length


def beam(
    length: float, height: float, counts: Sequence[int], kind: str = "quad4", width: float | None = None
) -> Mesh:
    """A beam 0 <= x <= length with its middle line on the x-axis.

    length, height, width [m] : width only for 3-D kinds, along y (default: the height). counts : parts along each
    coordinate. kind : of the elements. Boundaries: left, right (ends), bottom, top (last coordinate), in 3-D also
    front, back. Raises MeshError when a parameter is outside its range.
    """
    check_length("beam", "length", length)
    check_length("beam", "height", height)
    sides = [height]
    if find_kind(kind).dimension == 3:
        check_length("beam", "width", height if width is None else width)
        sides = [height if width is None else width, height]
    lower, upper = [-0.5 * side for side in sides], [0.5 * side for side in sides]
    return block([0.0, *lower], [length, *upper], counts, kind)

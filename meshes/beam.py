"""A straight beam along x."""

from collections.abc import Sequence

from core_models.errors import MeshError
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
        sides = [height if width is None else width, height]
        check_length("beam", "width", sides[0])
    elif width is not None:
        raise MeshError(f"beam: width is for 3-D elements; leave it out for {kind}")
    lower, upper = [-0.5 * side for side in sides], [0.5 * side for side in sides]
    return block([0.0, *lower], [length, *upper], counts, kind)

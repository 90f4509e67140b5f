"""Symmetry planes: nodes beyond a plane are the mirror images of those on the body's side.

What particles give to a node beyond is added to its image, the component normal to the plane with the opposite sign;
the velocity of a node beyond is that of its image, likewise. The axis of a body of revolution is such a plane.
"""

from typing import NamedTuple

import numpy as np

from core_models.compilation import inside_kernel, kernel
from core_models.errors import SceneError
from core_models.geometry import Axisymmetric, Geometry, axis_names
from core_models.loads import Load, Symmetry
from core_models.symmetry import symmetry_plane
from core_models.walls import Wall
from meshes.mesh import Mesh
from mpm.grid import VELOCITY, block_nodes

FIT = 1e-6  # cells that planes may be off whole numbers of cells


class Mirror(NamedTuple):
    """A symmetry plane: its axis, the number of its cell boundary counted from base, the body's side, its names."""

    axis: int
    cell: int
    side: int
    names: tuple[str, ...]

    def pairs(self, layers: int) -> list[tuple[int, int]]:
        """Node beyond the plane and its image along the axis, layer by layer outwards."""
        low, high = self.cell - 1, self.cell
        beyond, inside = (low, high) if self.side > 0 else (high, low)
        return [(beyond - self.side * layer, inside + self.side * layer) for layer in range(layers)]


def find_mirrors(
    mesh: Mesh, geometry: Geometry, loads: tuple[Load, ...], wall: Wall | None, cell_size: float
) -> tuple[np.ndarray, list[Mirror]]:
    """The point (3,) [m] that cells are counted from, and the symmetry planes.

    Raises SceneError for planes along one axis that are no whole number of cells apart.
    """
    dimension = mesh.dimension
    planes: dict[tuple[int, float, int], list[str]] = {}
    if isinstance(geometry, Axisymmetric):
        planes[0, 0.0, 1] = ["axis"]
    for load in loads:
        if isinstance(load, Symmetry):
            planes.setdefault(symmetry_plane(mesh, load.boundary), []).append(load.boundary)
    base = np.zeros(3)
    fixed: dict[int, str] = {dimension - 1: "the wall"} if wall is not None else {}
    mirrors = []
    for (axis, position, side), names in planes.items():
        if axis not in fixed:
            base[axis], fixed[axis] = position, repr(names[0])
        cells = (position - base[axis]) / cell_size
        if abs(cells - round(cells)) > FIT:
            name = axis_names(geometry)[axis]
            raise SceneError(
                f"the symmetry plane {names[0]!r} at {name} = {position:.6g} m is {abs(cells):.6g} cells of "
                f"{cell_size:.6g} m from {fixed[axis]} at {base[axis]:.6g} m: the grid needs a whole number of cells "
                f"between them, for example cells of {abs(position - base[axis]) / max(round(abs(cells)), 1):.6g} m"
            )
        mirrors.append(Mirror(axis, round(cells), side, tuple(names)))
    return base, mirrors


@kernel
def fold(geometry, grid, axis, beyond, image, records, size):
    """Add the records of the nodes `beyond` along an axis to those of their images, and clear them.

    records : flat, `size` numbers for each node: one or two pieces of a vector and a number.
    Returns the sum of the last vectors' components along the axis.
    """
    count = block_nodes(geometry)
    stride, place, steps, offset = layer(grid, axis, beyond, image)
    total = 0.0
    for block in range(grid.stored.shape[0] if 0 <= place < grid.shape[axis] else 0):
        if (grid.stored[block] // stride) % grid.shape[axis] != place:
            continue
        partner = grid.table[grid.stored[block] + steps * stride]
        if partner < 0:
            continue
        for local in range(count):
            if (local >> (2 * axis)) & 3 != beyond & 3:
                continue
            source = size * (block * count + local)
            target = size * (partner * count + local + offset)
            total += records[source + size - VELOCITY + axis]
            for c in range(size):
                sign = -1.0 if c & 3 == axis else 1.0
                records[target + c] += sign * records[source + c]
                records[source + c] = 0.0
    return total


@kernel
def reflect(geometry, grid, axis, beyond, image, velocities, size):
    """Set the velocities of the nodes `beyond` along an axis to the mirror images of those of their images.

    velocities : flat records of `size` numbers, the first three the velocity.
    """
    count = block_nodes(geometry)
    stride, place, steps, offset = layer(grid, axis, beyond, image)
    for block in range(grid.stored.shape[0] if 0 <= place < grid.shape[axis] else 0):
        if (grid.stored[block] // stride) % grid.shape[axis] != place:
            continue
        partner = grid.table[grid.stored[block] + steps * stride]
        if partner < 0:
            continue
        for local in range(count):
            if (local >> (2 * axis)) & 3 != beyond & 3:
                continue
            target = size * (block * count + local)
            source = size * (partner * count + local + offset)
            for c in range(3):
                velocities[target + c] = -velocities[source + c] if c == axis else velocities[source + c]


@inside_kernel
def layer(grid, axis, beyond, image):
    """Stride of the table along an axis, place of the block of the nodes `beyond`, blocks from there to those of their
    images, and the difference of the nodes' numbers within their blocks.
    """
    stride = 1
    for lower in range(axis):
        stride *= grid.shape[lower]
    place = (beyond >> 2) - grid.low[axis]
    return stride, place, (image >> 2) - (beyond >> 2), ((image & 3) - (beyond & 3)) << (2 * axis)

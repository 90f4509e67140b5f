"""Mirror images of points across the symmetry planes of a body."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from core_models.geometry import Axisymmetric, Geometry
from core_models.loads import Load, Symmetry
from core_models.symmetry import symmetry_plane


class Plane(NamedTuple):
    """A symmetry plane: the axis that it is normal to, its coordinate [m], the side on which the body lies (+1, -1)."""

    axis: int
    position: float
    side: int


def symmetry_planes(loads: Sequence[Load], mesh, geometry: Geometry) -> tuple[Plane, ...]:
    """The planes of all `Symmetry` loads, each once; in axisymmetry those normal to the axis.

    Raises SceneError as `symmetry_plane` does.
    """
    planes = (Plane(*symmetry_plane(mesh, load.boundary)) for load in loads if isinstance(load, Symmetry))
    first = 1 if isinstance(geometry, Axisymmetric) else 0
    return tuple({(plane.axis, plane.side): plane for plane in planes if plane.axis >= first}.values())


def mirror_images(
    positions: np.ndarray, planes: Sequence[Plane], reach: float
) -> tuple[np.ndarray, np.ndarray]:
    """Points and their images near them: positions (k, d) [m], and whose images they are (k,); the points come first.

        x -> 2 c - x   for a plane at c, and again for the images across another plane

    Parameters
    ----------
    positions : (n, d) [m]. planes : distinct; the points lie between them. reach : images farther from the box round
    the points than this are left out [m], >= 0.
    """
    owners = np.arange(len(positions))
    images = positions
    for axis in {plane.axis for plane in planes}:
        coordinates = [plane.position for plane in planes if plane.axis == axis]
        low, high = positions[:, axis].min() - reach, positions[:, axis].max() + reach
        layers = [(images, owners)]
        for start in range(len(coordinates)):
            layer, whose, plane = images, owners, start
            while True:
                layer = layer.copy()
                layer[:, axis] = 2.0 * coordinates[plane] - layer[:, axis]
                is_near = (layer[:, axis] >= low) & (layer[:, axis] <= high)
                layer, whose, plane = layer[is_near], whose[is_near], 1 - plane
                layers.append((layer, whose))
                if len(coordinates) == 1 or not len(layer):
                    break
        images = np.concatenate([layer for layer, _whose in layers])
        owners = np.concatenate([whose for _layer, whose in layers])
    return images, owners

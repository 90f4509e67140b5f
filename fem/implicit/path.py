"""Paths of equilibrium that an implicit body is followed along, instead of given times."""

from dataclasses import dataclass

import numpy as np

from core_models.equilibrium.measures import MeanDisplacement, Measure, PathLength
from core_models.errors import SceneError
from fem.supports import Supports
from meshes.boundaries import require_boundaries
from meshes.mesh import Mesh


@dataclass(frozen=True)
class BoundaryMotion:
    """The mean displacement of a component of a boundary grows at a speed [m/s], not 0; loads do what that takes."""

    boundary: str
    component: int
    speed: float


Path = PathLength | BoundaryMotion


def make_measure(path: Path, mesh: Mesh, supports: Supports) -> Measure:
    """What the way along the path is measured by.

    Raises SceneError for a path that is none, for a boundary or component that is not there or is held, and for
    supports that move: what is prescribed needs no path.
    """
    if supports.moving:
        raise SceneError(
            "a path is followed under loads, with supports that do not move: leave out 'path' where displacements are "
            "prescribed"
        )
    if isinstance(path, PathLength):
        return path
    if not isinstance(path, BoundaryMotion):
        raise SceneError(
            f"path = {path!r} is none: give PathLength(speed) or BoundaryMotion(boundary, component, speed)"
        )
    require_boundaries(mesh, [path.boundary])
    nodes = np.unique(mesh.boundaries[path.boundary])
    if path.component not in range(mesh.dimension):
        raise SceneError(f"component = {path.component!r} of 'path' is none: give 0 to {mesh.dimension - 1}")
    if not (np.isfinite(path.speed) and path.speed != 0.0):
        raise SceneError(f"speed = {path.speed!r} m/s of 'path' is out of range: give a finite number, not 0")
    if supports.fixed[nodes, path.component].all():
        raise SceneError(
            f"component {path.component} of {path.boundary!r} is held: 'path' needs a boundary that moves"
        )
    return MeanDisplacement(nodes, path.component, path.speed)

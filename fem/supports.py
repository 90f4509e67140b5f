"""Supports: components of nodal motion that are given, and the reactions there."""

import numpy as np

from core_models.errors import SceneError
from core_models.geometry import Axisymmetric, Geometry
from core_models.loads import Load, Symmetry, at_points, supports
from core_models.names import suggestion
from core_models.symmetry import symmetry_plane
from meshes.mesh import Mesh


class Supports:
    """Which components of which nodes are given.

    fixed : (n, d) bool. given : (n, d) velocities of these [m/s]. reactions : (n, d) impulses of the last step [N s],
    None where nothing but the axis holds the body.
    """

    def __init__(self, loads: tuple[Load, ...], mesh: Mesh, geometry: Geometry) -> None:
        self._points = mesh.points
        self.fixed = np.zeros(mesh.points.shape, dtype=np.bool_)
        self.given = np.zeros(mesh.points.shape)
        self._held: dict[str, list[tuple[np.ndarray, int]]] = {}
        self._moving = []
        for load in loads:
            if isinstance(load, Symmetry):
                self._hold(mesh, load.boundary, symmetry_plane(mesh, load.boundary)[0])
        for support in supports(loads, mesh.dimension):
            nodes = self._hold(mesh, support.boundary, support.component)
            if callable(support.velocity):
                self._moving.append((nodes, support.component, support.velocity))
            else:
                self.given[nodes, support.component] = support.velocity
        self.reactions = np.zeros(mesh.points.shape) if self._held else None
        if isinstance(geometry, Axisymmetric):
            self.fixed[:, 0] |= mesh.points[:, 0] == 0.0

    def _hold(self, mesh: Mesh, boundary: str, component: int) -> np.ndarray:
        nodes = np.unique(mesh.boundaries[boundary])
        self.fixed[nodes, component] = True
        self._held.setdefault(boundary, []).append((nodes, component))
        return nodes

    @property
    def moving(self) -> bool:
        """Whether a support has a velocity."""
        return bool(self._moving) or bool(self.given.any())

    def move_to(self, time: float) -> None:
        """Take the velocities of moving supports at a time [s], the middle of a step."""
        for nodes, component, velocity in self._moving:
            self.given[nodes, component] = at_points(velocity, self._points[nodes], time)

    def reaction(self, boundary: str) -> np.ndarray:
        """Impulse (d,) [N s] of the supports of a boundary on the body in the last step.

        Raises SceneError for a boundary that no support holds.
        """
        if boundary not in self._held:
            raise SceneError(
                f"no support holds {boundary!r}; {suggestion(boundary, self._held, 'nothing is held')}"
            )
        total = np.zeros(self._points.shape[1])
        for nodes, component in self._held[boundary]:
            total[component] += self.reactions[nodes, component].sum()
        return total

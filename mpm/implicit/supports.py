"""Supports: coefficients of the grid that are given, and the reactions there."""

import numpy as np

from core_models.errors import SceneError
from core_models.geometry import Axisymmetric, Geometry
from core_models.loads import Load, Symmetry, at_points, supports
from core_models.names import suggestion
from meshes.mesh import Mesh
from mpm.implicit.grid import SplineGrid
from mpm.implicit.planes import LOW, Plane
from mpm.implicit.weak_supports import WeakSupports


class Supports:
    """Which components of which coefficients are given: those of the functions that are not 0 on a held plane.

    A prescribed velocity is taken at their Greville abscissae: exact where it is linear along the plane, elsewhere of
    second order in the cells' size.

    fixed : (n, d) bool. given : (n, d) velocities [m/s]. reactions : (n, d) forces [N], None where nothing is held.
    """

    def __init__(
        self, loads: tuple[Load, ...], mesh: Mesh, geometry: Geometry, grid: SplineGrid, planes: dict[str, Plane],
        weak: WeakSupports,
    ) -> None:  # fmt: skip
        self._places, self._weak = grid.places, weak
        self.fixed = np.zeros(grid.places.shape, dtype=np.bool_)
        self.given = np.zeros(grid.places.shape)
        self._nodes = {name: _on(grid, plane) for name, plane in planes.items()}
        self._held: dict[str, set[int]] = {name: set() for name in planes}
        self._moving = []
        for load in loads:
            if isinstance(load, Symmetry) and load.boundary in planes:
                self._hold(load.boundary, planes[load.boundary].axis)
        for support in supports(loads, mesh.dimension):
            if support.boundary not in planes:
                continue
            nodes = self._hold(support.boundary, support.component)
            if callable(support.velocity):
                self._moving.append((nodes, support.component, support.velocity))
            else:
                self.given[nodes, support.component] = support.velocity
        self.reactions = np.zeros(grid.places.shape) if self._held else None
        if isinstance(geometry, Axisymmetric) and grid.axes[0].lines[0] == 0.0:
            self.fixed[_on(grid, Plane(0, LOW, 0.0)), 0] = True

    def _hold(self, boundary: str, component: int) -> np.ndarray:
        nodes = self._nodes[boundary]
        self.fixed[nodes, component] = True
        self._held[boundary].add(component)
        return nodes

    def move_to(self, time: float) -> None:
        """Take the velocities of moving supports at a time [s]."""
        for nodes, component, velocity in self._moving:
            self.given[nodes, component] = at_points(velocity, self._places[nodes], time)

    def reaction(self, boundary: str) -> np.ndarray:
        """Force (d,) [N] of the supports of a boundary on the body; SceneError for a boundary that no support holds."""
        if boundary in self._weak.names:
            return self._weak.reaction(boundary)
        if boundary not in self._held:
            known = (*self._held, *self._weak.names)
            raise SceneError(
                f"no support holds {boundary!r}; {suggestion(boundary, known, 'nothing is held')}"
            )
        total = np.zeros(self._places.shape[1])
        for component in self._held[boundary]:
            total[component] = self.reactions[self._nodes[boundary], component].sum()
        return total


def _on(grid: SplineGrid, plane: Plane) -> np.ndarray:
    """Functions (k,) that are not 0 on an end of the grid."""
    last = 0 if plane.end == LOW else grid.axes[plane.axis].count - 1
    return np.flatnonzero(grid.indices[:, plane.axis] == last)

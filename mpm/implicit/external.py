"""Forces on the coefficients of the grid from outside: body forces, tractions, and pressures with their stiffness.

Tractions and pressures act at the middles of the particles' faces. With A the reference area vector of a face there and
C = J F^-T at the same place, a pressure p gives the function a the force - p N_a C A, which follows the surface.
"""

import numpy as np

from core_models.equilibrium.gradient_operator import GradientOperator
from core_models.geometry import Geometry
from core_models.loads import REFERENCE, BodyForce, Load, Pressure, Traction, at_points, at_time
from mpm.implicit.grid import SplineGrid, gradients_at
from mpm.particles import Particles
from mpm.surface import Surface

_LEVI_CIVITA = np.zeros((3, 3, 3))
_LEVI_CIVITA[(0, 1, 2), (1, 2, 0), (2, 0, 1)] = 1.0
_LEVI_CIVITA[(0, 2, 1), (2, 1, 0), (1, 0, 2)] = -1.0


class PressedFaces:
    """The faces of a boundary under a pressure.

    dofs (k, a d) : degrees of freedom that each face reaches.
    """

    def __init__(
        self,
        load: Pressure,
        surface: Surface,
        grid: SplineGrid,
        geometry: Geometry,
        operator: GradientOperator,
    ) -> None:
        self._pressure = load.pressure
        points, d = surface.reference_points, grid.places.shape[1]
        self.nodes, self._values, slopes = grid.reach(points)
        slopes = gradients_at(geometry, points, self._values, slopes)
        # dF = sum over dofs of `slopes` times the change of the coefficient: (k, a, d, 3, 3).
        self._slopes = np.zeros((*self.nodes.shape, d, 9))
        for i in range(d):
            for j in range(operator.counts[i]):
                self._slopes[:, :, i, operator.rows[i, j]] = slopes[:, :, j]
        self._slopes = self._slopes.reshape(*self.nodes.shape, d, 3, 3)
        self._unit = np.diag([0.0, 0.0, 1.0 if slopes.shape[2] == 2 else 0.0])
        self._areas = np.zeros((len(points), 3))
        self._areas[:, :d] = surface.reference_vectors

    def forces(self, x: np.ndarray, time: float) -> np.ndarray:
        """Forces (k, a, d) [N] on the functions at coefficients x (n, d) [m]."""
        f = self._gradients(x)
        normals = 0.5 * np.einsum(
            "ikm,JLN,nkL,nmN,nJ->ni", _LEVI_CIVITA, _LEVI_CIVITA, f, f, self._areas, optimize=True
        )
        return -at_time(self._pressure, time) * np.einsum(
            "na,ni->nai", self._values, normals[:, : x.shape[1]]
        )

    def stiffness(self, x: np.ndarray, time: float) -> np.ndarray:
        """- d forces / dx: blocks (k, a d, a d) [N/m]."""
        d = x.shape[1]
        turned = np.einsum(
            "ikm,JLN,nmN,nJ->nikL", _LEVI_CIVITA, _LEVI_CIVITA, self._gradients(x), self._areas, optimize=True
        )
        slopes = np.einsum("nikL,nbjkL->nibj", turned[:, :d], self._slopes, optimize=True)
        blocks = at_time(self._pressure, time) * np.einsum("na,nibj->naibj", self._values, slopes)
        size = blocks.shape[1] * d
        return blocks.reshape(len(blocks), size, size)

    def _gradients(self, x: np.ndarray) -> np.ndarray:
        return self._unit + np.einsum("nai,naikL->nkL", x[self.nodes], self._slopes)


class ExternalForces:
    """Forces of the loads on the functions of a grid.

    loads : of `core_models.loads`. particles : in the reference body, `reached` : what `SplineGrid.reach` says of them.
    density : [kg/m^3].

    pressed : the faces under pressure.
    """

    def __init__(
        self, loads: tuple[Load, ...], particles: Particles, geometry: Geometry, grid: SplineGrid,
        reached: tuple[np.ndarray, np.ndarray], operator: GradientOperator, density: float,
    ) -> None:  # fmt: skip
        self._particles, self._count = particles, len(grid.places)
        self._nodes, self._values = reached
        self._mass = density * particles.volumes[:, None]
        self._bodies = [load for load in loads if isinstance(load, BodyForce)]
        self._tractions, self.pressed = [], []
        for load in loads:
            if isinstance(load, Traction | Pressure):
                surface = Surface(particles.faces[load.boundary], particles, geometry)
            if isinstance(load, Traction):
                nodes, values, _slopes = grid.reach(surface.reference_points)
                self._tractions.append((load, surface, nodes, values))
            if isinstance(load, Pressure):
                self.pressed.append(PressedFaces(load, surface, grid, geometry, operator))

    def at(self, x: np.ndarray, time: float) -> np.ndarray | None:
        """Forces (n, d) [N] at coefficients x (n, d) [m] at a time [s]; None if nothing acts."""
        if not (self._bodies or self._tractions or self.pressed):
            return None
        d = x.shape[1]
        forces = np.zeros_like(x)
        for load in self._bodies:
            at = self._particles.positions
            if load.at != REFERENCE:
                at = np.einsum("pa,pai->pi", self._values, x[self._nodes])
            self._add(forces, self._nodes, self._values, self._mass * at_points(load.function, at, time, d))
        for load, surface, nodes, values in self._tractions:
            traction = at_points(load.traction, surface.reference_points, time, d)
            self._add(forces, nodes, values, surface.reference_areas[:, None] * traction)
        for faces in self.pressed:
            self._sum(forces, faces.nodes, faces.forces(x, time))
        return forces

    def _add(self, forces: np.ndarray, nodes: np.ndarray, values: np.ndarray, at_points: np.ndarray) -> None:
        self._sum(forces, nodes, values[:, :, None] * at_points[:, None, :])

    def _sum(self, forces: np.ndarray, nodes: np.ndarray, parts: np.ndarray) -> None:
        for i in range(forces.shape[1]):
            forces[:, i] += np.bincount(nodes.ravel(), weights=parts[:, :, i].ravel(), minlength=self._count)

"""Prescribed motion where the grid does not end: stiff springs at the middles of the particles' faces.

A face of reference area A at X pulls at the functions that it reaches,

    f_a = N_a(X) k A [u*(X, t) - u(X)],   k = beta G / h

with u* the integral of the prescribed velocity, G the shear modulus and h the smallest side of a cell. Under a traction
t the body stays behind by t / k: a part t / (beta G) of a cell. Stiffer springs leave less, but their round-off more.
Source: Babuska, Math. Comput. 27 (1973) 221.
"""

import numpy as np

from core_models.equilibrium.route import SHARES, TIMES
from core_models.errors import SceneError
from core_models.geometry import Geometry
from core_models.loads import Prescribed, at_points
from mpm.implicit.grid import SplineGrid
from mpm.particles import Particles
from mpm.surface import Surface

BETA = 100.0


class WeakSupports:
    """The supports on boundaries that are no whole ends of the grid.

    supports : components that are prescribed. shear : modulus [Pa].

    names : of the boundaries. tables : degrees of freedom (k, a) that the faces of each support reach, blocks
    (k, a, a) : their stiffness [N/m]. reached (n, d) : components that some face pulls at. moved (faces,) : u* [m] at
    `time` [s]. reactions (supports, d) : forces on the body [N] then.
    """

    def __init__(
        self, supports: list[Prescribed], particles: Particles, geometry: Geometry, grid: SplineGrid, shear: float
    ) -> None:  # fmt: skip
        self._supports, self._places = supports, grid.places
        self.names = list(dict.fromkeys(support.boundary for support in supports))
        stiffness = BETA * shear / min(float(np.diff(axis.lines).min()) for axis in grid.axes)
        self.reached = np.zeros(grid.places.shape, dtype=np.bool_)
        self.tables, self.blocks, self._points, self._values, self._pulls = [], [], [], [], []
        d = grid.places.shape[1]
        for support in supports:
            if support.boundary not in particles.faces:
                raise SceneError(
                    f"the support on {support.boundary!r} holds the axis r = 0, where particles have no faces: take it "
                    "off (the axis is held radially without), or support another boundary"
                )
            surface = Surface(particles.faces[support.boundary], particles, geometry)
            nodes, values, _slopes = grid.reach(surface.reference_points)
            pulls = stiffness * surface.reference_areas[:, None] * values
            self.reached[nodes, support.component] = True
            self.tables.append(d * nodes + support.component)
            self.blocks.append(pulls[:, :, None] * values[:, None, :])
            self._points.append(surface.reference_points)
            self._values.append(values)
            self._pulls.append(pulls)
        self._cuts = np.cumsum([len(points) for points in self._points])[:-1]
        self.moved, self.time = np.zeros(sum(len(points) for points in self._points)), 0.0
        self._forces, self.reactions = np.zeros((2, len(supports), d))

    def pull(self, x: np.ndarray, time: float) -> np.ndarray:
        """Forces (n, d) [N] at coefficients x (n, d) [m] at a time [s] not before the last one that was accepted."""
        forces, u = np.zeros(x.size), (x - self._places).ravel()
        targets = self._targets(time)
        for i, support in enumerate(self._supports):
            table = self.tables[i]
            behind = targets[i] - (self._values[i] * u[table]).sum(axis=1)
            parts = self._pulls[i] * behind[:, None]
            self._forces[i] = 0.0
            self._forces[i, support.component] = parts.sum()
            forces += np.bincount(table.ravel(), weights=parts.ravel(), minlength=x.size)
        return forces.reshape(x.shape)

    def accept(self, time: float) -> None:
        """Go on from a time [s], at which the last forces were taken."""
        self.moved[:] = np.concatenate([*self._targets(time), np.zeros(0)])
        self.reactions[:], self.time = self._forces, time

    def reaction(self, boundary: str) -> np.ndarray:
        """Force (d,) [N] of the supports of a boundary on the body."""
        mine = [support.boundary == boundary for support in self._supports]
        return self.reactions[mine].sum(axis=0)

    def _targets(self, time: float) -> list[np.ndarray]:
        """Displacements u* [m] of the faces of each support at a time [s]."""
        step = time - self.time
        targets = np.split(self.moved.copy(), self._cuts)
        for i, support in enumerate(self._supports):
            for place, share in zip(TIMES, SHARES, strict=True):
                velocity = at_points(support.velocity, self._points[i], self.time + place * step)
                targets[i] = targets[i] + share * step * velocity
        return targets

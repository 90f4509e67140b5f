"""The body against the rigid wall: which faces may touch it, and what it has done in a step."""

from typing import NamedTuple

import numpy as np

from core_models.walls import PLANE, Wall
from mpm.background import Background
from mpm.gaps import measure_gaps
from mpm.grid import EDGE
from mpm.particles import Faces
from mpm.wall import meet_wall


class Push(NamedTuple):
    """What the wall did: normal impulse [N s], work of normal and of tangential impulses, kinetic energy added [J]."""

    impulse: float = 0.0
    work: float = 0.0
    rubbed: float = 0.0
    energy: float = 0.0


class Contact:
    """The wall, the faces of the body's rim, and their memory of having touched it.

    Parameters
    ----------
    wall : kind and friction. surface : all faces of the rim.
    """

    def __init__(self, wall: Wall, surface: Faces) -> None:
        self.wall = wall
        self._particles = np.ascontiguousarray(surface.particles)
        self._corners = np.ascontiguousarray(surface.corners)
        self.touched = np.zeros(len(self._particles), dtype=np.bool_)
        self._gaps, self._held = np.zeros(0), np.zeros(0, dtype=np.bool_)

    def measure(
        self, background: Background, positions: np.ndarray, deformation_gradient: np.ndarray
    ) -> None:
        """Measure the gaps between surface and wall."""
        shape = background.grid.shape
        columns = int(EDGE * shape[0] * (EDGE * shape[1] if positions.shape[1] == 3 else 1))
        if len(self._gaps) != columns:
            self._gaps, self._held = np.zeros(columns), np.zeros(columns, dtype=np.bool_)
        measure_gaps(
            background.geometry, background.grid, positions, deformation_gradient, self._particles, self._corners,
            self.wall.kind == PLANE, self.touched, self._gaps, self._held,
        )  # fmt: skip

    def meet(self, background: Background, dt: float) -> Push:
        """Stop what would pass the wall within dt [s]."""
        return Push(
            *meet_wall(
                background.geometry,
                background.shape,
                background.grid,
                dt,
                self.wall.friction,
                self._gaps,
                self._held,
            )
        )

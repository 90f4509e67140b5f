"""The deformed body from the deformed domains of the particles: domains, and boundaries as their corners."""

import math
from functools import cached_property

import numpy as np

from core_models.errors import SceneError
from core_models.geometry import Axisymmetric, Geometry
from core_models.names import suggestion
from mpm.particles import Faces

# Of the body's size: reference corners nearer than this are one. No mesh has nodes at odd multiples of half of it.
SAME_PLACE = 1e-9 * math.pi


def deformed(
    which: np.ndarray | slice, offsets: np.ndarray, positions: np.ndarray, deformation_gradient: np.ndarray
) -> np.ndarray:
    """Positions x_p + F_p dX (k, c, d) [m] of points at offsets dX (k, c, d) from particles in the reference body."""
    d = positions.shape[1]
    turned = np.einsum("nij,ncj->nci", deformation_gradient[which, :d, :d], offsets)
    return positions[which][:, None, :] + turned


class Boundary:
    """The named boundaries of the body, carried by the particles.

    Corners of neighbouring faces that were one point in the reference body, here also across names, are one point: the
    mean of where the faces put it. On the axis of a body of revolution r is 0.

    Parameters
    ----------
    faces : by name. reference : (n, d) positions of the particles in the reference body [m]. geometry : of the body.
    """

    def __init__(self, faces: dict[str, Faces], reference: np.ndarray, geometry: Geometry) -> None:
        self.faces, self._reference = faces, reference
        self._revolved = isinstance(geometry, Axisymmetric)

    @cached_property
    def _numbers(self) -> tuple[np.ndarray, np.ndarray, dict[str, np.ndarray]]:
        """Number of each face corner's point, which points lie on the axis, and the part of each name."""
        names = list(self.faces)
        starts = [self._reference[f.particles][:, None] + f.corners for f in self.faces.values()]
        flat = np.concatenate([corners.reshape(-1, corners.shape[2]) for corners in starts])
        size = np.ptp(flat, axis=0).max() or 1.0
        cells = np.rint((flat - flat.min(axis=0)) / (SAME_PLACE * size)).astype(np.int64)
        _, first, number = np.unique(cells, axis=0, return_index=True, return_inverse=True)
        on_axis = (
            np.abs(flat[first, 0]) <= SAME_PLACE * size
            if self._revolved
            else np.zeros(len(first), dtype=bool)
        )
        pieces = np.split(number.ravel(), np.cumsum([c.shape[0] * c.shape[1] for c in starts])[:-1])
        return number.ravel(), on_axis, dict(zip(names, pieces, strict=True))

    def _points(self, positions: np.ndarray, deformation_gradient: np.ndarray) -> np.ndarray:
        """Current positions (m, d) [m] of the numbered points."""
        number, on_axis, _ = self._numbers
        corners = np.concatenate(
            [
                deformed(f.particles, f.corners, positions, deformation_gradient).reshape(
                    -1, positions.shape[1]
                )
                for f in self.faces.values()
            ]
        )
        uses = np.bincount(number)
        sums = [np.bincount(number, weights=corners[:, k]) for k in range(positions.shape[1])]
        points = np.column_stack(sums) / uses[:, None]
        if self._revolved:
            points[:, 0] = np.where(on_axis, 0.0, np.maximum(points[:, 0], 0.0))
        return points

    def lines(self, positions: np.ndarray, deformation_gradient: np.ndarray) -> dict[str, np.ndarray]:
        """In two dimensions, each boundary as a line (k, 2) [m], head to tail, piece after piece."""
        points = self._points(positions, deformation_gradient)
        lines = {}
        for name, numbers in self._numbers[2].items():
            ends = numbers.reshape(-1, 2)
            last = np.append(ends[1:, 0] != ends[:-1, 1], True)
            keep = np.column_stack([np.ones(len(ends), dtype=bool), last])
            lines[name] = points[ends[keep]]
        return lines

    def corners(self, name: str, positions: np.ndarray, deformation_gradient: np.ndarray) -> np.ndarray:
        """Current positions (k, d) [m] of the points of a boundary, each once; SceneError for an unknown one."""
        if name not in self._numbers[2]:
            raise SceneError(f"the body has no boundary {name!r}; {suggestion(name, self._numbers[2])}")
        return self._points(positions, deformation_gradient)[np.unique(self._numbers[2][name])]

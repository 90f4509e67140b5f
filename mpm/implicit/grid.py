"""A grid of B-splines over the reference body: the cells that particles are in, and the functions that these carry."""

import numpy as np

from core_models.geometry import Axisymmetric, Geometry
from mpm.implicit.planes import HIGH, LOW
from mpm.implicit.splines import Splines


class SplineGrid:
    """Products of splines along the axes; cells and functions count where there are particles.

    Parameters
    ----------
    degree : of the splines. lines : along each axis [m]. ends : (axis, LOW or HIGH) where body and grid end together.
    positions : of the particles in the reference body (n, d) [m].

    cells (m, d) : places along the axes of the cells with particles. starts (m + 1,), order (n,) : particles
    order[starts[e]] ... belong to cell e. nodes (m, a) : functions of each cell. indices (k, d) : places of
    the functions along the axes. places (k, d) : their Greville abscissae [m]: as coefficients they leave X as it is.
    """

    def __init__(
        self, degree: int, lines: list[np.ndarray], ends: set[tuple[int, int]], positions: np.ndarray
    ) -> None:
        self.axes = [Splines(degree, each) for each in lines]
        self.degree, self._ends = degree, ends
        self._shape = tuple(axis.cells for axis in self.axes)
        own = np.ravel_multi_index(tuple(self._inside(positions).T), self._shape)
        active, number = np.unique(own, return_inverse=True)
        self.cells = np.column_stack(np.unravel_index(active, self._shape))
        self._number = np.full(self._shape, -1)
        self._number.flat[active] = np.arange(len(active))
        self.order = np.argsort(number, kind="stable")
        self.starts = np.searchsorted(number[self.order], np.arange(len(active) + 1))
        counts = tuple(axis.count for axis in self.axes)
        functions = np.ravel_multi_index(tuple(np.moveaxis(self._around(self.cells), 2, 0)), counts)
        used, nodes = np.unique(functions, return_inverse=True)
        self.nodes = nodes.reshape(functions.shape)
        self.indices = np.column_stack(np.unravel_index(used, counts))
        self.places = np.column_stack([axis.places[self.indices[:, i]] for i, axis in enumerate(self.axes)])

    @property
    def rim(self) -> np.ndarray:
        """Which cells (m,) have a neighbour without particles, across a corner too: those that the body may cut."""
        d = len(self._shape)
        filled = np.pad(self._number >= 0, 1)
        for axis in range(d):
            for end, at, inside in ((LOW, 0, 1), (HIGH, -1, -2)):
                if (axis, end) in self._ends:
                    line = [slice(None)] * d
                    line[axis] = at
                    copied = line.copy()
                    copied[axis] = inside
                    filled[tuple(line)] = filled[tuple(copied)]
        offsets = np.stack(np.meshgrid(*[(0, 1, 2)] * d, indexing="ij"), axis=-1).reshape(-1, d)
        around = [filled[tuple((self.cells + offset).T)] for offset in offsets]
        return ~np.all(around, axis=0)

    def neighbours(self, axis: int) -> tuple[np.ndarray, np.ndarray]:
        """Numbers of the cells with a next one along an axis, and of these next ones."""
        following = self.cells.copy()
        following[:, axis] += 1
        there = following[:, axis] < self._shape[axis]
        numbers = np.full(len(self.cells), -1)
        numbers[there] = self._number[tuple(following[there].T)]
        first = np.flatnonzero(numbers >= 0)
        return first, numbers[first]

    def reach(self, points: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Functions (k, a) that points (k, d) [m] reach, their values (k, a) and slopes (k, a, d) [1/m].

        A point in a cell without particles counts for the nearest one with some.
        """
        k, d = points.shape
        inside = self._inside(points)
        numbers = self._number[tuple(inside.T)]
        for point in np.flatnonzero(numbers < 0):
            numbers[point] = int(np.abs(self.cells - inside[point]).sum(axis=1).argmin())
        cells = self.cells[numbers]
        along = [
            (axis.values(points[:, i], cells[:, i]), axis.values(points[:, i], cells[:, i], 1))
            for i, axis in enumerate(self.axes)
        ]
        values = _product([value for value, _slope in along])
        slopes = [
            _product([slope if i == j else value for i, (value, slope) in enumerate(along)]) for j in range(d)
        ]
        return self.nodes[numbers], values, np.stack(slopes, axis=2)

    def _inside(self, points: np.ndarray) -> np.ndarray:
        return np.column_stack([axis.cells_of(points[:, i]) for i, axis in enumerate(self.axes)])

    def _around(self, cells: np.ndarray) -> np.ndarray:
        """Places (m, a, d) along the axes of the functions of cells (m, d), the last axis fastest."""
        steps = np.indices((self.degree + 1,) * cells.shape[1]).reshape(cells.shape[1], -1).T
        return cells[:, None] + steps


def _product(factors: list[np.ndarray]) -> np.ndarray:
    """Products (k, a) of values (k, p + 1) along each axis, the last axis fastest."""
    product = factors[0]
    for factor in factors[1:]:
        product = (product[:, :, None] * factor[:, None, :]).reshape(len(factor), -1)
    return product


def gradients_at(
    geometry: Geometry, points: np.ndarray, values: np.ndarray, slopes: np.ndarray
) -> np.ndarray:
    """Slopes (k, a, D) for `core_models.equilibrium.gradient_operator`, at points (k, d) [m]: the hoop comes last."""
    if not isinstance(geometry, Axisymmetric):
        return slopes
    return np.concatenate([slopes, (values / points[:, :1])[:, :, None]], axis=2)

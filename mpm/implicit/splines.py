"""B-splines along one axis of the grid, on cells of any size.

Knots are the lines between cells, those at both ends repeated degree + 1 times: the first function alone is not 0 on
the first line, the last one on the last. Cell e carries the functions e ... e + degree. In between, the functions are
those of mpm.interpolation on cells of one size.
Source: Piegl & Tiller, The NURBS Book (1997), A2.2 and equation 2.7.
"""

import numpy as np

DEGREES = {"linear": 1, "quadratic": 2, "cubic": 3}


class Splines:
    """The functions of one axis.

    degree : p, 1 to 3. lines : (cells + 1,) ascending [m].

    cells, count : numbers of cells and of functions, cells + p.
    """

    def __init__(self, degree: int, lines: np.ndarray) -> None:
        self.degree, self.lines = degree, lines
        self.cells, self.count = len(lines) - 1, len(lines) - 1 + degree
        self._knots = np.concatenate([np.full(degree, lines[0]), lines, np.full(degree, lines[-1])])

    @property
    def places(self) -> np.ndarray:
        """Greville abscissae (count,) [m]: with these as coefficients the sum of the functions is x."""
        windows = np.lib.stride_tricks.sliding_window_view(self._knots[1:-1], self.degree)
        return windows.mean(axis=1)

    def cells_of(self, x: np.ndarray) -> np.ndarray:
        """Cells (n,) that x (n,) [m] lie in; the nearest for what lies outside."""
        return np.clip(np.searchsorted(self.lines, x, side="right") - 1, 0, self.cells - 1)

    def values(self, x: np.ndarray, cells: np.ndarray, derivative: int = 0) -> np.ndarray:
        """Values (n, p + 1) at x (n,) [m] of the functions of some cells (n,), or of a derivative [m^-derivative].

        They are the polynomials of these cells, also at x outside.
        """
        p, knots = self.degree, self._knots
        values = np.ones((len(x), 1))
        for k in range(1, p + 1):
            following = np.zeros((len(x), k + 1))
            for a in range(k):
                low, high = knots[cells + p - k + 1 + a], knots[cells + p + 1 + a]
                if k > p - derivative:
                    slope = k * values[:, a] / (high - low)
                    following[:, a] -= slope
                    following[:, a + 1] += slope
                else:
                    part = (x - low) / (high - low)
                    following[:, a] += (1.0 - part) * values[:, a]
                    following[:, a + 1] += part * values[:, a]
            values = following
        return values

    def jumps(self) -> np.ndarray:
        """Jumps (cells - 1, p + 2) of the p-th derivative [m^-p] across the lines inside, of the functions nearby.

        Line l between the cells l - 1 and l is row l - 1, of the functions l - 1 ... l + p.
        """
        cells = np.arange(self.cells)
        top = self.values(self.lines[:-1], cells, self.degree)
        jumps = np.zeros((self.cells - 1, self.degree + 2))
        jumps[:, 1:] += top[1:]
        jumps[:, :-1] -= top[:-1]
        return jumps

"""Intel's PARDISO as a solver of sparse linear systems, through the package pypardiso."""

from typing import Any

import numpy as np

from core_models.equilibrium.pattern import Pattern
from core_models.equilibrium.stalled import Stalled

# PARDISO's numbers: all of a solution, the same without the ordering, which the pattern alone decides.
_ALL, _WITHOUT_ORDERING = 13, 23
_SYMMETRIC_PATTERN = 1  # matrices whose pattern is symmetric, though their numbers need not be


class Pardiso:
    """PARDISO for real matrices of symmetric pattern, which is put in order once."""

    name = "pardiso"

    def __init__(self, pattern: Pattern) -> None:
        self._pattern = pattern
        self._solver = _make_solver()

    def solve(self, values: np.ndarray, right: np.ndarray) -> np.ndarray:
        """See `core_models.equilibrium.linear_solvers.LinearSolver`."""
        from pypardiso.pardiso_wrapper import PyPardisoError
        from scipy.sparse import csr_matrix

        pattern = self._pattern
        matrix = csr_matrix((values, pattern.columns, pattern.row_starts), shape=(pattern.size, pattern.size))
        try:
            found = self._solver.solve(matrix, right)
        except PyPardisoError as reason:
            raise Stalled(f"the stiffness is singular ({reason})") from None
        self._solver.ordered = True
        return found


def _make_solver() -> Any:
    from pypardiso import PyPardisoSolver

    class OrderedOnce(PyPardisoSolver):
        ordered = False

        def set_phase(self, phase: int) -> None:
            super().set_phase(_WITHOUT_ORDERING if self.ordered and phase == _ALL else phase)

    return OrderedOnce(mtype=_SYMMETRIC_PATTERN)

"""SciPy's SuperLU as a solver of sparse linear systems."""

import numpy as np

from core_models.equilibrium.pattern import Pattern
from core_models.equilibrium.stalled import Stalled


class SuperLU:
    """SciPy's SuperLU with the minimum degree ordering of K + K^T."""

    name = "scipy"

    def __init__(self, pattern: Pattern) -> None:
        self._pattern = pattern

    def solve(self, values: np.ndarray, right: np.ndarray) -> np.ndarray:
        """See `core_models.equilibrium.linear_solvers.LinearSolver`."""
        from scipy.sparse import csc_matrix
        from scipy.sparse.linalg import splu

        pattern = self._pattern
        # Compressed rows of K read as columns are K^T, which needs no conversion.
        shape = (pattern.size, pattern.size)
        transpose = csc_matrix((values, pattern.columns, pattern.row_starts), shape=shape)
        try:
            factors = splu(transpose, permc_spec="MMD_AT_PLUS_A", options={"SymmetricMode": False})
        except RuntimeError:
            raise Stalled("the stiffness is singular") from None
        return factors.solve(right, trans="T")

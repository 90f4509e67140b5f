"""Direct solvers of sparse linear systems: SciPy's SuperLU, or PARDISO where it is installed."""

from importlib.util import find_spec
from typing import Protocol

import numpy as np

from core_models.equilibrium.pattern import Pattern
from core_models.equilibrium.stalled import Stalled
from core_models.errors import SceneError, UnsupportedError
from core_models.names import suggestion

SCIPY, PARDISO = "scipy", "pardiso"
LINEAR_SOLVERS = (SCIPY, PARDISO)


class LinearSolver(Protocol):
    """Solves K x = b for the matrix of a pattern, which need not be symmetric."""

    name: str

    def solve(self, values: np.ndarray, right: np.ndarray) -> np.ndarray:
        """x (n,) for numbers (entries,) of K and b (n,); Stalled if K is singular."""


class SuperLU:
    """SciPy's SuperLU with the minimum degree ordering of K + K^T."""

    name = SCIPY

    def __init__(self, pattern: Pattern) -> None:
        self._pattern = pattern

    def solve(self, values: np.ndarray, right: np.ndarray) -> np.ndarray:
        """See `LinearSolver`."""
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


class Pardiso:
    """Intel's PARDISO for real unsymmetric matrices, through the package pypardiso."""

    name = PARDISO

    def __init__(self, pattern: Pattern) -> None:
        from pypardiso import PyPardisoSolver

        self._pattern = pattern
        self._solver = PyPardisoSolver(mtype=11)

    def solve(self, values: np.ndarray, right: np.ndarray) -> np.ndarray:
        """See `LinearSolver`."""
        from pypardiso.pardiso_wrapper import PyPardisoError
        from scipy.sparse import csr_matrix

        pattern = self._pattern
        matrix = csr_matrix((values, pattern.columns, pattern.row_starts), shape=(pattern.size, pattern.size))
        try:
            self._solver.factorize(matrix)
            return self._solver.solve(matrix, right)
        except PyPardisoError as reason:
            raise Stalled(f"the stiffness is singular ({reason})") from None


def make_linear_solver(name: str | None, pattern: Pattern) -> LinearSolver:
    """The linear solver of that name; by default PARDISO where it can be imported, else SciPy's.

    Raises SceneError for an unknown name, UnsupportedError for PARDISO where it is not installed.
    """
    if name not in (None, *LINEAR_SOLVERS):
        raise SceneError(f"no linear solver is called {name!r}; {suggestion(name, LINEAR_SOLVERS)}")
    installed = find_spec("pypardiso") is not None
    if name == PARDISO and not installed:
        raise UnsupportedError(
            "PARDISO is not installed: install the extra 'solvers', or use linear_solver='scipy'"
        )
    return Pardiso(pattern) if installed and name != SCIPY else SuperLU(pattern)

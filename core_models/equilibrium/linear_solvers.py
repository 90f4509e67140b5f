"""Solvers of sparse linear systems by name: SciPy's SuperLU, PARDISO and PETSc where they are installed."""

from importlib.util import find_spec
from typing import Protocol

import numpy as np

from core_models.equilibrium.pardiso import Pardiso
from core_models.equilibrium.pattern import Pattern
from core_models.equilibrium.petsc import Petsc
from core_models.equilibrium.superlu import SuperLU
from core_models.errors import SceneError, UnsupportedError
from core_models.names import suggestion


class LinearSolver(Protocol):
    """Solves K x = b for the matrix of a pattern, which is symmetric, though K need not be."""

    name: str

    def solve(self, values: np.ndarray, right: np.ndarray) -> np.ndarray:
        """x (n,) or (n, k) for numbers (entries,) of K and b (n,) or (n, k); Stalled if K is singular."""


_CLASSES = {each.name: each for each in (SuperLU, Pardiso, Petsc)}
LINEAR_SOLVERS = tuple(_CLASSES)
_MODULES = {Pardiso.name: "pypardiso", Petsc.name: "petsc4py"}
_EXTRAS = {
    Pardiso.name: "PARDISO is not installed: install the extra 'solvers'",
    Petsc.name: "PETSc is not installed: install the extra 'hpc', which needs PETSc itself (Debian: petsc-dev)",
}


def make_linear_solver(name: str | None, pattern: Pattern) -> LinearSolver:
    """The linear solver of that name; by default PARDISO where it can be imported, else SciPy's.

    Raises SceneError for an unknown name, UnsupportedError for one that is not installed.
    """
    if name not in (None, *LINEAR_SOLVERS):
        raise SceneError(f"no linear solver is called {name!r}; {suggestion(name, LINEAR_SOLVERS)}")
    if name is None:
        name = Pardiso.name if _is_installed(Pardiso.name) else SuperLU.name
    if not _is_installed(name):
        raise UnsupportedError(f"{_EXTRAS[name]}, or use linear_solver='scipy'")
    return _CLASSES[name](pattern)


def _is_installed(name: str) -> bool:
    return name not in _MODULES or find_spec(_MODULES[name]) is not None

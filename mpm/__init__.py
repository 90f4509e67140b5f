"""Material point method on a background grid: explicit dynamics, and implicit quasi-statics."""

from mpm.implicit.solver import ImplicitSolver
from mpm.solver import Solver

DISTRIBUTION = "matpoint"

__all__ = ["ImplicitSolver", "Solver"]

"""Material point method: explicit dynamics on a background grid."""

from mpm.solver import Solver

DISTRIBUTION = "matpoint"

__all__ = ["Solver"]

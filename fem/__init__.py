"""Finite element method on scikit-fem spaces: explicit dynamics, and implicit quasi-statics."""

from fem.explicit import ExplicitSolver
from fem.implicit.solver import ImplicitSolver

DISTRIBUTION = "matpoint"

__all__ = ["ExplicitSolver", "ImplicitSolver"]

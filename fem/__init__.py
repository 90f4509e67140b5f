"""Finite element method: explicit dynamics on scikit-fem spaces."""

from fem.explicit import ExplicitSolver

DISTRIBUTION = "matpoint"

__all__ = ["ExplicitSolver"]

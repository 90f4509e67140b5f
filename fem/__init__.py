"""Finite element method on scikit-fem spaces: explicit dynamics, and implicit quasi-statics."""

from core_models.equilibrium.measures import PathLength
from fem.explicit import ExplicitSolver
from fem.implicit.path import BoundaryMotion
from fem.implicit.solver import ImplicitSolver

DISTRIBUTION = "matpoint"

__all__ = ["BoundaryMotion", "ExplicitSolver", "ImplicitSolver", "PathLength"]

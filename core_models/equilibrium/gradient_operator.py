"""Which components of the deformation gradient a nodal displacement changes, in each geometry."""

from typing import NamedTuple

import numpy as np

from core_models.geometry import Axisymmetric, Geometry


class GradientOperator(NamedTuple):
    """dF[rows[i, J]] = du_ai gradients[..., a, J] for J < counts[i], with row 3 i + J of F in row-major order.

    rows : (d, D). counts : (d,); the hoop of the axisymmetric body depends on the radial displacement only.
    """

    rows: np.ndarray
    counts: np.ndarray


def gradient_operator(geometry: Geometry, dimension: int) -> GradientOperator:
    """The operator of a geometry for gradients (..., a, D): those of the shape functions, and N / R for the hoop."""
    if isinstance(geometry, Axisymmetric):
        return GradientOperator(np.array([[0, 1, 8], [3, 4, 8]]), np.array([3, 2]))
    rows = 3 * np.arange(dimension)[:, None] + np.arange(dimension)
    return GradientOperator(rows, np.full(dimension, dimension))

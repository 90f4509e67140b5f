"""How a body of particles starts: gradients of its velocity and displacement, from functions."""

from collections.abc import Callable
from typing import Any

import numpy as np

from core_models.geometry import Axisymmetric, Geometry
from core_models.initial_motion import field_values

DIFFERENCE = 1e-5  # of the body's size: step of the central differences of fields given as functions


def field_gradients(function: Callable[[np.ndarray], Any], positions: np.ndarray) -> np.ndarray:
    """Gradients (n, d, d) of a field by central differences."""
    step = DIFFERENCE * float(np.ptp(positions, axis=0).max())
    columns = []
    for shift in step * np.eye(positions.shape[1]):
        ahead, behind = (np.asarray(function(positions + s), dtype=np.float64) for s in (shift, -shift))
        columns.append(np.broadcast_to((ahead - behind) / (2.0 * step), positions.shape))
    return np.stack(columns, axis=2)


def initial_gradients(
    function: Callable[[np.ndarray], Any], positions: np.ndarray, geometry: Geometry
) -> np.ndarray:
    """Deformation gradients (n, 3, 3) of an initial displacement u(X)."""
    d = positions.shape[1]
    gradients = np.tile(np.eye(3), (len(positions), 1, 1))
    gradients[:, :d, :d] += field_gradients(function, positions)
    if isinstance(geometry, Axisymmetric):
        gradients[:, 2, 2] += field_values("displacement", function, positions, "m")[:, 0] / positions[:, 0]
    return gradients

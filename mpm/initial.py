"""How a body starts: its velocity, its velocity gradient and its deformation, from numbers, vectors or functions."""

import math
from collections.abc import Callable
from typing import Any

import numpy as np

from core_models.arguments import check_between
from core_models.errors import SceneError
from core_models.geometry import Axisymmetric, Geometry

DIFFERENCE = 1e-5  # of the body's size: step of the central differences of fields given as functions
STAGES = 16  # in which an initial deformation is applied, so that the energy it stores is that of the path


def initial_velocities(velocity: Any, positions: np.ndarray) -> np.ndarray:
    """Velocities (n, d) [m/s] at positions (n, d) from a number (along the last axis), a vector (d,) or a function.

    Raises SceneError for what is none of these, or not finite.
    """
    d = positions.shape[1]
    if callable(velocity):
        return field_values("velocity", velocity, positions)
    if np.ndim(velocity) == 0:
        axial = check_between("velocity", velocity, -math.inf, math.inf, "m/s")
        return np.tile([0.0] * (d - 1) + [axial], (len(positions), 1))
    vector = np.asarray(velocity, dtype=np.float64)
    if vector.shape != (d,) or not np.isfinite(vector).all():
        raise SceneError(f"velocity = {velocity!r} is no velocity: give a number or {d} finite ones [m/s]")
    return np.tile(vector, (len(positions), 1))


def field_values(name: str, function: Callable[[np.ndarray], Any], positions: np.ndarray) -> np.ndarray:
    """Values (n, d) of a field at positions; SceneError unless they are finite and as many."""
    try:
        values = np.broadcast_to(np.asarray(function(positions), dtype=np.float64), positions.shape)
    except ValueError as error:
        raise SceneError(
            f"{name}: the function gives no array of shape {positions.shape} at so many positions: {error}"
        ) from None
    if not np.isfinite(values).all():
        place = positions[int((~np.isfinite(values)).any(axis=1).argmax())].tolist()
        raise SceneError(f"{name}: the function gives {name}s that are not finite, for example at {place} m")
    return np.array(values, order="C")


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
        gradients[:, 2, 2] += field_values("displacement", function, positions)[:, 0] / positions[:, 0]
    return gradients

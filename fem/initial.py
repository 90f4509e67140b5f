"""Initial positions and velocities of the nodes."""

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike

from core_models.errors import SceneError


def initial_velocities(velocity: float | ArrayLike | Callable, points: np.ndarray) -> np.ndarray:
    """Velocities (n, d) [m/s] at positions (n, d) from a number along the last axis, a vector, or a function.

    Raises SceneError when that does not give finite numbers of the right shape.
    """
    value = velocity(points) if callable(velocity) else velocity
    value = np.asarray(value, dtype=np.float64)
    if value.ndim == 0:
        value = np.concatenate([np.zeros(points.shape[1] - 1), value[None]])
    return _field("velocity", value, points, "m/s")


def initial_positions(displacement: Callable, points: np.ndarray) -> np.ndarray:
    """Positions (n, d) [m] displaced by a function of the reference positions (n, d).

    Raises SceneError when that does not give finite numbers of the right shape.
    """
    return points + _field("displacement", np.asarray(displacement(points), dtype=np.float64), points, "m")


def _field(name: str, value: np.ndarray, points: np.ndarray, unit: str) -> np.ndarray:
    dimension = points.shape[1]
    if value.shape not in ((dimension,), points.shape):
        raise SceneError(
            f"{name} has the shape {value.shape}: give {dimension} components [{unit}], or an array {points.shape}"
        )
    if not np.isfinite(value).all():
        raise SceneError(f"{name} is not finite everywhere: give finite numbers [{unit}]")
    return np.array(np.broadcast_to(value, points.shape), order="C")

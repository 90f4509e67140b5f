"""How a body starts to move: fields of its velocity and its displacement from numbers, vectors or functions."""

from collections.abc import Callable
from typing import Any

import numpy as np

from core_models.arguments import check_function
from core_models.errors import SceneError


def initial_velocities(velocity: Any, positions: np.ndarray) -> np.ndarray:
    """Velocities (n, d) [m/s] at positions (n, d) from a number along the last axis, a vector (d,), or a function.

    Raises SceneError for what is none of these, or not finite.
    """
    if callable(velocity):
        return field_values("velocity", velocity, positions, "m/s")
    value = _numbers("velocity", velocity, positions, "m/s")
    if value.ndim == 0:
        value = np.concatenate([np.zeros(positions.shape[1] - 1), value[None]])
    return _spread("velocity", value, positions, "m/s")


def field_values(
    name: str, function: Callable[[np.ndarray], Any], positions: np.ndarray, unit: str
) -> np.ndarray:
    """Values (n, d) of a function of positions (n, d); SceneError unless they are finite and as many."""
    if not callable(function):
        raise SceneError(f"{name} = {function!r} is no function of positions: give one, or None")
    check_function(name, function, "positions (n, d)")
    return _spread(name, _numbers(name, function(positions), positions, unit), positions, unit)


def _numbers(name: str, value: Any, positions: np.ndarray, unit: str) -> np.ndarray:
    try:
        return np.asarray(value, dtype=np.float64)
    except (TypeError, ValueError):
        raise SceneError(
            f"{name} = {value!r} is no {name}: give {positions.shape[1]} numbers [{unit}], or a function of positions"
        ) from None


def _spread(name: str, value: np.ndarray, positions: np.ndarray, unit: str) -> np.ndarray:
    dimension = positions.shape[1]
    if value.shape not in ((dimension,), positions.shape):
        raise SceneError(
            f"{name} has the shape {value.shape}: give {dimension} components [{unit}], or an array {positions.shape}"
        )
    values = np.array(np.broadcast_to(value, positions.shape), order="C")
    bad = ~np.isfinite(values).all(axis=1)
    if bad.any():
        place = ", ".join(f"{x:.4g}" for x in positions[int(bad.argmax())])
        raise SceneError(f"{name} is not finite at ({place}) m: give finite numbers [{unit}]")
    return values

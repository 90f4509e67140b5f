"""Checks of the numbers that a solver is built with."""

import inspect
import math
from typing import Any

import numpy as np

from core_models.errors import SceneError, UnsupportedError


def check_between(name: str, value: float, low: float, high: float, unit: str = "") -> float:
    """The value if low < value <= high and it is finite; SceneError with the range otherwise."""
    if isinstance(value, int | float) and math.isfinite(value) and low < value <= high:
        return float(value)
    limits = f"above {low:g}" + (f", at most {high:g}" if math.isfinite(high) else "")
    raise SceneError(
        f"{name} = {value!r} {unit}".rstrip() + f" is out of range: give a finite number {limits}"
    )


def check_function(what: str, value: Any, *given: str) -> None:
    """Refuse a function that cannot be called with what it will be given; SceneError. Anything else passes."""
    if not callable(value):
        return
    try:
        signature = inspect.signature(value)
    except (TypeError, ValueError):
        return  # compiled functions may have none
    try:
        signature.bind(*given)
    except TypeError:
        raise SceneError(
            f"{what} is a function {signature}, but is called with {' and '.join(given)}: give a function of "
            f"{len(given)} argument{'s' * (len(given) > 1)}"
        ) from None


def check_share(name: str, value: float) -> None:
    """Refuse a share that is not from 0 to 1; SceneError."""
    if value != 0.0:
        check_between(name, value, 0.0, 1.0)


def check_not_negative(name: str, values: float | np.ndarray, unit: str) -> None:
    """Refuse a number, or an array with one, that is negative or not finite; SceneError with the first."""
    numbers = np.atleast_1d(values)
    bad = numbers[~(np.isfinite(numbers) & (numbers >= 0.0))]
    if bad.size:
        raise SceneError(f"{name} of {bad[0]:g} {unit}: give finite numbers, not below 0")


def numbers_of(name: str, values: Any, shape: tuple[int | None, ...]) -> np.ndarray:
    """The values as a contiguous array of numbers of the shape, None for any length above 0; SceneError otherwise."""
    wanted = (
        f"({', '.join('n' if length is None else str(length) for length in shape)}{',' * (len(shape) == 1)})"
    )
    try:
        array = np.ascontiguousarray(values, dtype=np.float64)
    except (TypeError, ValueError):
        raise SceneError(f"{name} is no array of numbers: give one of the shape {wanted}") from None
    fits = len(array.shape) == len(shape) and array.size > 0
    if not fits or any(length not in (None, found) for length, found in zip(shape, array.shape, strict=True)):
        raise SceneError(f"{name} has the shape {array.shape}: give numbers of the shape {wanted}, n > 0")
    return array


def check_step(dt: float) -> None:
    """Refuse a time step [s] that is not positive; SceneError."""
    if not dt > 0.0:
        raise SceneError(f"a time step must be positive, not {dt:g} s")


def require_writable(name: str, array: np.ndarray, shape: tuple[int, ...]) -> None:
    """Raise UnsupportedError for an array that a kernel cannot fill as it is: a copy would be filled, and lost."""
    if array.shape != shape or array.dtype != np.float64 or not array.flags.carray:
        state = "" if array.flags.carray else ", not contiguous or not writable"
        raise UnsupportedError(
            f"{name} is an array {array.shape} of {array.dtype}{state}: give np.empty({shape})"
        )

"""Checks of the numbers that a solver is built with."""

import math

from core_models.errors import SceneError


def check_between(name: str, value: float, low: float, high: float, unit: str = "") -> float:
    """The value if low < value <= high and it is finite; SceneError with the range otherwise."""
    if isinstance(value, int | float) and math.isfinite(value) and low < value <= high:
        return float(value)
    limits = f"above {low:g}" + (f", at most {high:g}" if math.isfinite(high) else "")
    raise SceneError(
        f"{name} = {value!r} {unit}".rstrip() + f" is out of range: give a finite number {limits}"
    )


def check_motion(velocity: float, temperature: float | None) -> None:
    """Refuse an initial velocity [m/s] that is not finite, or a temperature [K] that is not above 0; SceneError."""
    check_between("velocity", velocity, -math.inf, math.inf, "m/s")
    if temperature is not None:
        check_between("temperature", temperature, 0.0, math.inf, "K")


def check_share(name: str, value: float) -> None:
    """Refuse a share that is not from 0 to 1; SceneError."""
    if value != 0.0:
        check_between(name, value, 0.0, 1.0)

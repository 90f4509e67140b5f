"""What acts on a body from outside: the same descriptions for every method.

Boundaries are named parts of a mesh's rim. Positions x and X are arrays (n, d) [m], current and reference; t is the
time [s]. A function may return one value for all points or one for each.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from core_models.errors import SceneError

CURRENT = "current"
REFERENCE = "reference"

VectorField = Callable[[np.ndarray, float], ArrayLike]


@dataclass(frozen=True)
class BodyForce:
    """Body force per mass b(x, t) [m/s^2] on the whole body.

    function : takes positions (n, d) and time, returns (n, d) or (d,). at : 'current' or 'reference' positions.
    """

    function: VectorField
    at: str = CURRENT


@dataclass(frozen=True)
class Damping:
    """Mass-proportional damping: a force - rate m v on everything that moves; rate [1/s], >= 0, a number or rate(t).

    It leads to the static solution; critical for a mode of angular frequency w at rate 2 w.
    """

    rate: float | Callable[[float], float]


@dataclass(frozen=True)
class Prescribed:
    """Velocity [m/s] of one component along a boundary: a number, or a function of (X, t).

    component : 0 ... d-1. The rest of the motion there is free.
    """

    boundary: str
    component: int
    velocity: float | VectorField = 0.0


@dataclass(frozen=True)
class Fixed:
    """A boundary that does not move at all."""

    boundary: str


@dataclass(frozen=True)
class Symmetry:
    """A plane boundary, normal to a coordinate axis, in which the body is mirrored: no normal motion, no shear."""

    boundary: str


@dataclass(frozen=True)
class Traction:
    """Dead traction [Pa] on a boundary, force per reference area: a vector (d,), or a function of (X, t)."""

    boundary: str
    traction: ArrayLike | VectorField


@dataclass(frozen=True)
class Pressure:
    """Pressure [Pa] on a boundary, along the current normal on the current area, positive inwards; number or p(t)."""

    boundary: str
    pressure: float | Callable[[float], float]


@dataclass(frozen=True)
class FixedTemperature:
    """Temperature [K] of a boundary: a number or T(t). Only with conduction."""

    boundary: str
    temperature: float | Callable[[float], float]


@dataclass(frozen=True)
class HeatFlux:
    """Heat flux [W/m^2] into the body through a boundary, per reference area: a number or q(t); needs conduction."""

    boundary: str
    flux: float | Callable[[float], float]


Load = BodyForce | Damping | Prescribed | Fixed | Symmetry | Traction | Pressure | FixedTemperature | HeatFlux


def gravity(acceleration: ArrayLike) -> BodyForce:
    """Uniform body force of a given acceleration (d,) [m/s^2]."""
    vector = np.asarray(acceleration, dtype=np.float64)
    return BodyForce(lambda x, t: vector)


def displaced(boundary: str, component: int, history: Callable[[float], float], step: float) -> Prescribed:
    """Prescribed displacement u(t) [m] of one component: its velocity by central differences over `step` [s]."""
    return Prescribed(
        boundary,
        component,
        lambda _x, t: (history(t + 0.5 * step) - history(max(t - 0.5 * step, 0.0))) / step,
    )


def at_time(value: Any, time: float) -> float:
    """Value of a number or of a function of time; SceneError for what is no finite number."""
    raw = value(time) if callable(value) else value
    try:
        number = float(raw)
    except (TypeError, ValueError):
        raise SceneError(f"a load gives {raw!r} at t = {time:.6g} s: give a number") from None
    if not math.isfinite(number):
        raise SceneError(f"a load gives {number} at t = {time:.6g} s: give a finite number")
    return number


def at_points(value: Any, positions: np.ndarray, time: float, components: int = 0) -> np.ndarray:
    """Values (n,) or, with `components` d, (n, d) of a constant or a function of position and time.

    Raises SceneError for values of another shape, a single number for a vector among them, and for infinite ones.
    """
    raw = value(positions, time) if callable(value) else value
    shape = (len(positions), components) if components else (len(positions),)
    allowed = ((components,), shape) if components else ((), shape)
    try:
        values = np.asarray(raw, dtype=np.float64)
    except (TypeError, ValueError):
        raise SceneError(f"a load gives {raw!r} at t = {time:.6g} s: give numbers") from None
    if values.shape not in allowed:
        one = f"a vector of {components} components" if components else "a number"
        raise SceneError(
            f"a load gives an array of shape {values.shape} at t = {time:.6g} s: give {one}, or an array {shape}"
        )
    if not np.isfinite(values).all():
        bad = ~np.isfinite(np.broadcast_to(values, shape)).reshape(len(positions), -1).all(axis=1)
        place = ", ".join(f"{x:.4g}" for x in positions[int(bad.argmax())])
        raise SceneError(
            f"a load gives a number that is not finite at ({place}) m, t = {time:.6g} s: give finite ones"
        )
    return np.broadcast_to(values, shape)


def supports(loads: tuple[Load, ...], dimension: int) -> list[Prescribed]:
    """All prescribed components of motion: `Fixed` spelled out."""
    found = [load for load in loads if isinstance(load, Prescribed)]
    for load in loads:
        if isinstance(load, Fixed):
            found += [Prescribed(load.boundary, component) for component in range(dimension)]
    return found

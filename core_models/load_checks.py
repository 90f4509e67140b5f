"""Refusals of loads that cannot act on a mesh as asked, with the numbers that show why."""

from typing import Any

import numpy as np

from core_models.agreement import Agreement
from core_models.arguments import check_function
from core_models.errors import SceneError
from core_models.geometry import Axisymmetric, Geometry, axis_names
from core_models.loads import (
    CURRENT,
    REFERENCE,
    BodyForce,
    Damping,
    FixedTemperature,
    HeatFlux,
    Load,
    Prescribed,
    Pressure,
    Symmetry,
    Traction,
    at_points,
    at_time,
)
from core_models.names import suggestion
from core_models.symmetry import symmetry_plane

PLACE, TIME = "positions (n, d)", "time"
ARGUMENTS = {
    BodyForce: {"function": (PLACE, TIME)},
    Prescribed: {"velocity": (PLACE, TIME)},
    Traction: {"traction": (PLACE, TIME)},
    Pressure: {"pressure": (TIME,)},
    Damping: {"rate": (TIME,)},
    FixedTemperature: {"temperature": (TIME,)},
    HeatFlux: {"flux": (TIME,)},
}
"""What the functions of loads are given."""
ON_AREAS = Traction | Pressure | HeatFlux | FixedTemperature


def check_loads(loads: tuple[Load, ...], mesh, geometry: Geometry, *, conduction: bool = False) -> Agreement:
    """Refuse what cannot be: unknown boundaries or components, contradictions, tractions on the axis; SceneError.

    Returns what watches that supports which are functions of time go on agreeing.
    """
    if not isinstance(loads, tuple | list):
        raise SceneError(f"loads = {loads!r} is no collection of loads: give a tuple, empty for none")
    for load in loads:
        if not isinstance(load, Load):
            raise SceneError(f"{load!r} is no load: use one of core_models.loads")
        if isinstance(load, BodyForce) and not callable(load.function):
            raise SceneError(
                f"BodyForce: {load.function!r} is no function of positions and time: use gravity(vector) for a constant"
            )
        if isinstance(load, BodyForce) and load.at not in (CURRENT, REFERENCE):
            raise SceneError(f"a body force is taken at 'current' or 'reference' positions, not {load.at!r}")
        name = getattr(load, "boundary", None)
        if hasattr(load, "boundary") and not (isinstance(name, str) and name in mesh.boundaries):
            raise SceneError(
                f"{type(load).__name__}: the mesh has no boundary {name!r}; {suggestion(name, mesh.boundaries)}"
            )
        if isinstance(load, Prescribed) and not _is_component(load.component, mesh.dimension):
            raise SceneError(
                f"Prescribed on {name!r}: component {load.component!r} does not exist in {mesh.dimension} dimensions: "
                f"give 0 to {mesh.dimension - 1}"
            )
        _check_values(load, mesh)
        if isinstance(load, Symmetry):
            symmetry_plane(mesh, name, axis_names(geometry))
        if isinstance(load, FixedTemperature | HeatFlux) and not conduction:
            raise SceneError(f"{type(load).__name__} on {name!r} does nothing without conduction: turn it on")
        if isinstance(load, ON_AREAS) and isinstance(geometry, Axisymmetric):
            _refuse_axis(load, mesh)
    return Agreement(loads, mesh, geometry)


def damping_of(loads: tuple[Load, ...]) -> Damping | None:
    """The one damping among the loads, or None; SceneError for two, or for a rate below 0."""
    found = [load for load in loads if isinstance(load, Damping)]
    if len(found) > 1:
        raise SceneError(f"{len(found)} dampings act on the same body: give one, with the sum of the rates")
    for damping in found:
        damping_rate(damping, 0.0)
    return found[0] if found else None


def damping_rate(damping: Damping | None, time: float) -> float:
    """Rate [1/s] of a damping, 0 without one, at a time [s]; SceneError for one below 0."""
    rate = at_time(damping.rate, time) if damping else 0.0
    if rate < 0.0:
        raise SceneError(
            f"Damping: rate = {rate:g} 1/s at t = {time:.6g} s is out of range: give a finite number from 0"
        )
    return rate


def _is_component(component: Any, dimension: int) -> bool:
    whole = isinstance(component, int | np.integer) and not isinstance(component, bool)
    return whole and 0 <= component < dimension


def _check_values(load: Load, mesh) -> None:
    """Refuse functions that do not take what they are given, and values at t = 0 that cannot be; SceneError."""
    name = getattr(load, "boundary", None)
    what = type(load).__name__ + (f" on {name!r}" if name else "")
    for field, given in ARGUMENTS.get(type(load), {}).items():
        check_function(f"{what}: {field}", getattr(load, field), *given)
    points = mesh.points[np.unique(mesh.boundaries[name])] if name else mesh.points
    try:
        if isinstance(load, BodyForce):
            at_points(load.function, points, 0.0, mesh.dimension)
        elif isinstance(load, Traction):
            at_points(load.traction, points, 0.0, mesh.dimension)
        elif isinstance(load, Prescribed):
            at_points(load.velocity, points, 0.0)
        elif isinstance(load, Pressure):
            at_time(load.pressure, 0.0)
    except SceneError as error:
        raise SceneError(f"{what}: {error}") from None


def _refuse_axis(load: Load, mesh) -> None:
    nodes = np.unique(mesh.boundaries[load.boundary])
    radius = mesh.points[nodes, 0]
    if radius.max() == 0.0:
        raise SceneError(
            f"{type(load).__name__} on {load.boundary!r}: all of its {len(nodes)} nodes lie on the axis r = 0, "
            "which has no area: take it off"
        )

"""Refusals of loads that cannot act on a mesh as asked, with the numbers that show why."""

import numpy as np

from core_models.errors import SceneError
from core_models.geometry import Axisymmetric, Geometry
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
    supports,
)
from core_models.names import suggestion

FLAT = 1e-9  # largest departure of a symmetry boundary from its plane, as a part of the body's size
AXES = "xyz"
ON_AREAS = Traction | Pressure | HeatFlux | FixedTemperature


def check_loads(loads: tuple[Load, ...], mesh, geometry: Geometry, *, conduction: bool = False) -> None:
    """Refuse what cannot be: unknown boundaries or components, contradictions, tractions on the axis; SceneError."""
    for load in loads:
        if not isinstance(load, Load):
            raise SceneError(f"{load!r} is no load: use one of core_models.loads")
        if isinstance(load, BodyForce) and load.at not in (CURRENT, REFERENCE):
            raise SceneError(f"a body force is taken at 'current' or 'reference' positions, not {load.at!r}")
        name = getattr(load, "boundary", None)
        if name is not None and name not in mesh.boundaries:
            raise SceneError(
                f"{type(load).__name__}: the mesh has no boundary {name!r}; {suggestion(name, mesh.boundaries)}"
            )
        if isinstance(load, Prescribed) and load.component not in range(mesh.dimension):
            raise SceneError(
                f"Prescribed on {name!r}: component {load.component!r} does not exist in {mesh.dimension} dimensions: "
                f"give 0 to {mesh.dimension - 1}"
            )
        if isinstance(load, Symmetry):
            symmetry_plane(mesh, name)
        if isinstance(load, FixedTemperature | HeatFlux) and not conduction:
            raise SceneError(f"{type(load).__name__} on {name!r} does nothing without conduction: turn it on")
        if isinstance(load, ON_AREAS) and isinstance(geometry, Axisymmetric):
            _refuse_axis(load, mesh)
    _refuse_contradictions(loads, mesh, geometry)


def damping_of(loads: tuple[Load, ...]) -> Damping | None:
    """The one damping among the loads, or None; SceneError for two."""
    found = [load for load in loads if isinstance(load, Damping)]
    if len(found) > 1:
        raise SceneError(f"{len(found)} dampings act on the same body: give one, with the sum of the rates")
    return found[0] if found else None


def symmetry_plane(mesh, name: str) -> tuple[int, float, int]:
    """Axis normal to a symmetry boundary, its coordinate [m], and the side of it on which the body lies (+1, -1).

    Raises SceneError for a boundary that is not flat, not normal to an axis or has the body on both sides.
    """
    points = mesh.points[np.unique(mesh.boundaries[name])]
    size = float(np.ptp(mesh.points, axis=0).max())
    spread = np.ptp(points, axis=0)
    axis = int(spread.argmin())
    if spread[axis] > FLAT * size:
        raise SceneError(
            f"Symmetry on {name!r}: its nodes spread over {spread[axis]:.3g} m along {AXES[axis]}: "
            "a symmetry boundary is a plane normal to a coordinate axis"
        )
    position = float(points[:, axis].mean())
    low, high = mesh.points[:, axis].min() - position, mesh.points[:, axis].max() - position
    if low < -FLAT * size and high > FLAT * size:
        raise SceneError(
            f"Symmetry on {name!r}: the body reaches from {low:.3g} to {high:.3g} m on both sides of the plane "
            f"{AXES[axis]} = {position:.6g} m: mesh only one side"
        )
    return axis, position, 1 if high > FLAT * size else -1


def _refuse_axis(load: Load, mesh) -> None:
    nodes = np.unique(mesh.boundaries[load.boundary])
    radius = mesh.points[nodes, 0]
    if radius.max() == 0.0:
        raise SceneError(
            f"{type(load).__name__} on {load.boundary!r}: all of its {len(nodes)} nodes lie on the axis r = 0, "
            "which has no area: take it off"
        )


def _refuse_contradictions(loads: tuple[Load, ...], mesh, geometry: Geometry) -> None:
    """Two supports that want different motions of the same node, or one that moves a node off its plane or axis."""
    held: dict[tuple[int, int], tuple[float, str]] = {}

    def hold(name: str, component: int, nodes: np.ndarray, velocities: np.ndarray) -> None:
        for node, velocity in zip(nodes.tolist(), velocities.tolist(), strict=True):
            other, owner = held.setdefault((node, component), (velocity, name))
            if other != velocity:
                place = ", ".join(f"{x:.6g}" for x in mesh.points[node])
                raise SceneError(
                    f"contradictory supports at node {node} ({place}) m: motion along {AXES[component]} is held at "
                    f"{other:g} m/s by {owner!r} and at {velocity:g} m/s by {name!r} at t = 0: free one of them"
                )

    if isinstance(geometry, Axisymmetric):
        nodes = np.flatnonzero(mesh.points[:, 0] == 0.0)
        hold("the axis", 0, nodes, np.zeros(len(nodes)))
    for load in loads:
        if isinstance(load, Symmetry):
            nodes = np.unique(mesh.boundaries[load.boundary])
            hold(load.boundary, symmetry_plane(mesh, load.boundary)[0], nodes, np.zeros(len(nodes)))
    for support in supports(loads, mesh.dimension):
        nodes = np.unique(mesh.boundaries[support.boundary])
        hold(support.boundary, support.component, nodes, at_points(support.velocity, mesh.points[nodes], 0.0))

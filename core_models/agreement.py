"""Whether the supports of a body agree where several of them hold the same motion, now and later."""

from itertools import combinations
from typing import Any, NamedTuple

import numpy as np

from core_models.errors import SceneError
from core_models.geometry import Axisymmetric, Geometry, axis_names
from core_models.loads import Load, Symmetry, at_points, supports
from core_models.symmetry import symmetry_plane

ALIKE = 1e-9  # of the larger one: velocities nearer than this are one


class Motion(NamedTuple):
    """A component of motion that a boundary holds. nodes (k,) : its nodes. velocity : number or function of (X, t)."""

    boundary: str
    component: int
    nodes: np.ndarray
    velocity: Any


class Agreement:
    """Pairs of supports that hold the same component at common nodes; refuses those that contradict each other.

    Parameters
    ----------
    loads : of `core_models.loads`. mesh : of the body. geometry : of the body.

    Raises SceneError for a contradiction at t = 0; `check` does for later ones.
    """

    def __init__(self, loads: tuple[Load, ...], mesh, geometry: Geometry) -> None:
        self._points, self._names = mesh.points, axis_names(geometry)
        held = held_motions(loads, mesh, geometry)
        self._pairs = []
        for first, second in combinations(held, 2):
            common = np.intersect1d(first.nodes, second.nodes)
            if first.component == second.component and len(common) and first.velocity is not second.velocity:
                self._pairs.append((common, first, second))
        self.check(0.0)
        self._pairs = [
            pair for pair in self._pairs if callable(pair[1].velocity) or callable(pair[2].velocity)
        ]

    def check(self, time: float) -> None:
        """Refuse velocities that differ at a time [s]; SceneError with place, supports and velocities."""
        for nodes, first, second in self._pairs:
            one, other = (at_points(m.velocity, self._points[nodes], time) for m in (first, second))
            off = np.abs(one - other) > ALIKE * np.maximum(np.abs(one), np.abs(other))
            if off.any():
                k = int(off.argmax())
                place = ", ".join(f"{x:.6g}" for x in self._points[nodes[k]])
                raise SceneError(
                    f"contradictory supports at node {nodes[k]} ({place}) m: motion along "
                    f"{self._names[first.component]} is held at {one[k]:g} m/s by {first.boundary!r} and at "
                    f"{other[k]:g} m/s by {second.boundary!r} at t = {time:.6g} s: free one of them"
                )


def mirrored_motions(loads: tuple[Load, ...], mesh, geometry: Geometry) -> list[Motion]:
    """Components of motion that the axis and symmetry planes hold at rest."""
    held = []
    if isinstance(geometry, Axisymmetric):
        held.append(Motion("the axis", 0, np.flatnonzero(mesh.points[:, 0] == 0.0), 0.0))
    for load in loads:
        if isinstance(load, Symmetry):
            nodes = np.unique(mesh.boundaries[load.boundary])
            held.append(Motion(load.boundary, symmetry_plane(mesh, load.boundary)[0], nodes, 0.0))
    return held


def held_motions(loads: tuple[Load, ...], mesh, geometry: Geometry) -> list[Motion]:
    """All components of motion that are held: by the axis, symmetry planes and supports."""
    held = mirrored_motions(loads, mesh, geometry)
    for load in supports(loads, mesh.dimension):
        nodes = np.unique(mesh.boundaries[load.boundary])
        held.append(Motion(load.boundary, load.component, nodes, load.velocity))
    return held

"""Prescribed motion of boundaries: impulses at the middles of the particles' faces.

With W the interpolation of nodal velocities to these points and M the nodal masses, the impulses j solve

    W M^-1 W^T j = v* - W v

so that the interpolated velocity meets the prescribed one with the least change of motion: the nodes get W^T j, which
is how the reaction of a boundary is spread over them. More points than nodes leave j open; the conjugate gradients that
solve for it take the smallest.
"""

from typing import NamedTuple

import numpy as np

from core_models.errors import SceneError
from core_models.geometry import Geometry
from core_models.loads import Load, Prescribed, at_points, supports
from mpm.anchors import Anchors
from mpm.background import Background
from mpm.particles import Particles
from mpm.surface import Surface

MOST_ITERATIONS = 60
CLOSE = 1e-8  # of the largest velocity to be corrected
ROUND_OFF = 1e-13  # of the largest velocity: changes smaller than that are none


class Hold(NamedTuple):
    """What supports did in a step [J].

    work : impulses times prescribed velocities. lost : where the body starts with other velocities.
    energy : that was added to the kinetic energy of the grid. impulses : (d,) [N s] by boundary.
    """

    work: float
    lost: float
    energy: float
    impulses: dict[str, np.ndarray]


class Supports:
    """The boundaries with prescribed motion among the loads.

    Parameters
    ----------
    loads : of `core_models.loads`. particles : in the reference body.
    """

    def __init__(self, loads: tuple[Load, ...], particles: Particles, geometry: Geometry) -> None:
        self._dimension = particles.positions.shape[1]
        held = supports(loads, self._dimension)
        self.names = list(dict.fromkeys(load.boundary for load in held))
        for name in self.names:
            if name not in particles.faces:
                raise SceneError(
                    f"the support on {name!r} holds the axis r = 0, where particles have no faces: take it off (the "
                    "axis is held radially without), or support another boundary"
                )
        self._surfaces = {name: Surface(particles.faces[name], particles, geometry) for name in self.names}
        self._by_axis: list[list[Prescribed]] = [
            [load for load in held if load.component == axis] for axis in range(self._dimension)
        ]

    def impose(
        self,
        background: Background,
        time: float,
        positions: np.ndarray,
        deformation_gradient: np.ndarray,
        starting: bool,
    ) -> Hold:
        """Change the velocities after the forces so that they are those prescribed at a time [s].

        starting : whether this is the body's first step.
        """
        total = {name: np.zeros(self._dimension) for name in self.names}
        places = {
            name: s.places(background.configuration, positions, deformation_gradient)
            for name, s in self._surfaces.items()
        }
        work, lost, energy = 0.0, 0.0, 0.0
        for axis, loads in enumerate(self._by_axis):
            if not loads:
                continue
            anchors = background.anchors(np.concatenate([places[load.boundary] for load in loads]))
            wanted = np.concatenate(
                [
                    at_points(load.velocity, self._surfaces[load.boundary].reference_points, time)
                    for load in loads
                ]
            )
            found = anchors.after(axis)
            scale = max(float(np.abs(wanted).max()), float(np.abs(found).max()))
            impulses = solve(anchors, axis, wanted - found, ROUND_OFF * scale)
            anchors.push(axis, impulses)
            reached = anchors.after(axis)
            work += float((impulses * reached).sum())
            lost += anchors.jump(axis) if starting else 0.0
            energy += 0.5 * float((impulses * (found + reached)).sum())
            cuts = np.cumsum([len(places[load.boundary]) for load in loads])[:-1]
            for load, part in zip(loads, np.split(impulses, cuts), strict=True):
                total[load.boundary][axis] += part.sum()
        return Hold(work, lost, energy, total)


def solve(anchors: Anchors, axis: int, wanted: np.ndarray, smallest: float) -> np.ndarray:
    """Impulses (k,) [N s] at the points that change their velocities by `wanted` (k,) [m/s]: conjugate gradients.

    smallest : change of velocity [m/s] that does not matter.
    """
    impulses, rest = np.zeros_like(wanted), wanted.copy()
    direction, square = rest.copy(), float((rest * rest).sum())
    goal = max(CLOSE * float(np.abs(wanted).max()), smallest)
    for _ in range(MOST_ITERATIONS):
        if float(np.abs(rest).max()) <= goal:
            break
        response = anchors.response(axis, direction)
        step = square / float((direction * response).sum())
        impulses += step * direction
        rest -= step * response
        square, before = float((rest * rest).sum()), square
        direction = rest + square / before * direction
    return impulses

"""Prescribed motion of boundaries: impulses at the middles of the particles' faces.

With W the interpolation of nodal velocities to these points and M the nodal masses, the impulses j solve

    W M^-1 W^T j = v* - W v

so that the interpolated velocity meets the prescribed one with the least change of motion: the nodes get W^T j, which
is how the reaction of a boundary is spread over them. More points than nodes leave j open; the conjugate gradients that
solve for it take the smallest.
"""

from typing import NamedTuple

import numpy as np

from core_models.errors import RunFailure, SceneError
from core_models.geometry import Geometry
from core_models.loads import Load, Prescribed, at_points, supports
from mpm.anchors import Anchors
from mpm.background import Background
from mpm.particles import Particles
from mpm.surface import Surface

MOST_ITERATIONS = 400
CLOSE = 1e-8  # of the largest velocity to be corrected
FAR = 1e-2  # of that: what may be left where points almost coincide
ROUND_OFF = 1e-13  # of the largest velocity: changes smaller than that are none


class Hold(NamedTuple):
    """What supports did in a step [J].

    work : impulses times the mean of the velocities prescribed for the last step and this one. lost : what the body
    brings with other velocities than those of the last step. later : impulses times velocities after.
    energy : that was added to the kinetic energy of the grid. impulses : (k, d) [N s] of the boundaries.
    """

    work: float
    lost: float
    later: float
    energy: float
    impulses: np.ndarray


class Supports:
    """The boundaries with prescribed motion among the loads.

    Parameters
    ----------
    loads : of `core_models.loads`. particles : in the reference body.

    names : of the boundaries. reactions : (k, d) theirs on the body in the last step [N].
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
        self.reactions = np.zeros((len(self.names), self._dimension))
        self._surfaces = {name: Surface(particles.faces[name], particles, geometry) for name in self.names}
        self._by_axis: list[list[Prescribed]] = [
            [load for load in held if load.component == axis] for axis in range(self._dimension)
        ]

    def impose(
        self,
        background: Background,
        earlier: float,
        time: float,
        positions: np.ndarray,
        deformation_gradient: np.ndarray,
    ) -> Hold:
        """Change the velocities after the forces so that they are those prescribed at a time [s].

        earlier : time of the last step's velocities [s]; the present one in the first step.
        Raises RunFailure where the prescribed velocities cannot be reached.
        """
        total = np.zeros_like(self.reactions)
        places = {
            name: s.places(background.configuration, positions, deformation_gradient)
            for name, s in self._surfaces.items()
        }
        work, lost, later, energy = 0.0, 0.0, 0.0, 0.0
        for axis, loads in enumerate(self._by_axis):
            if not loads:
                continue
            anchors = background.anchors(np.concatenate([places[load.boundary] for load in loads]))
            last, wanted = (self._prescribed(loads, at) for at in (earlier, time))
            found = anchors.after(axis)
            scale = max(float(np.abs(wanted).max()), float(np.abs(found).max()))
            impulses = solve(anchors, axis, wanted - found, ROUND_OFF * scale)
            anchors.push(axis, impulses)
            reached = anchors.after(axis)
            work += 0.5 * float((impulses * (last + reached)).sum())
            lost += 0.5 * float((impulses * (last - anchors.before(axis))).sum())
            later += float((impulses * reached).sum())
            energy += 0.5 * float((impulses * (found + reached)).sum())
            cuts = np.cumsum([len(places[load.boundary]) for load in loads])[:-1]
            for load, part in zip(loads, np.split(impulses, cuts), strict=True):
                total[self.names.index(load.boundary), axis] += part.sum()
        return Hold(work, lost, later, energy, total)

    def _prescribed(self, loads: list[Prescribed], time: float) -> np.ndarray:
        """Prescribed velocities (k,) [m/s] of all points of some supports."""
        points = [self._surfaces[load.boundary].reference_points for load in loads]
        return np.concatenate(
            [at_points(load.velocity, at, time) for load, at in zip(loads, points, strict=True)]
        )


def solve(anchors: Anchors, axis: int, wanted: np.ndarray, smallest: float) -> np.ndarray:
    """Impulses (k,) [N s] at the points that change their velocities by `wanted` (k,) [m/s]: conjugate gradients,
    each point's residual in proportion to the impulse that would remove it.

    smallest : change of velocity [m/s] that does not matter.
    Raises RunFailure where no impulses do that.
    """
    impulses, rest, over = np.zeros_like(wanted), wanted.copy(), 1.0 / anchors.own_response(axis)
    direction, square = over * rest, float((rest * over * rest).sum())
    largest = float(np.abs(wanted).max())
    goal = max(CLOSE * largest, smallest)
    for _ in range(MOST_ITERATIONS):
        if float(np.abs(rest).max()) <= goal:
            return impulses
        response = anchors.response(axis, direction)
        power = float((direction * response).sum())
        if not power > 0.0:
            break
        step = square / power
        impulses += step * direction
        rest -= step * response
        square, before = float((rest * over * rest).sum()), square
        direction = over * rest + square / before * direction
    if not float(np.abs(rest).max()) <= FAR * largest:
        raise RunFailure(
            f"the supports cannot hold the body: velocities of component {axis} are off by up to "
            f"{float(np.abs(rest).max()):.3g} m/s where {largest:.3g} m/s are to be corrected; supports within a cell "
            "of each other have to agree: use smaller cells, or take one of them off"
        )
    return impulses

"""The rigid wall in the total configuration: impulses at the middles of the faces of the body's rim.

A point with current height x_s and normal velocity v_s = sum W_si v_i, W at its place in the reference body, gets
impulses j_s on its nodes such that

    x_s + dt v_s >= 0,   j_s >= 0,   j_s (x_s + dt v_s) = 0,   |tangential impulse| <= friction j_s,

or v_s = 0 with impulses of either sign where a plane wall holds it. The system W M^-1 W^T of these conditions is
solved point by point in a fixed order (projected Gauss-Seidel); tangential motion is brought to rest as far as friction
goes.
"""

import math

import numpy as np

from core_models.compilation import kernel
from core_models.walls import PLANE, Wall
from mpm.background import Background
from mpm.contact import Push
from mpm.grid import Grid
from mpm.surface import Surface

NEAR = 1.0  # cells: points higher than this are out of reach of the wall in a step
TOUCHING = 1e-3  # cells: height at which a point counts as on the wall
MOST_SWEEPS = 100
CLOSE = 1e-9  # of the largest velocity: changes within a sweep that are none


@kernel
def press(points, local, weights, nodes, masses, velocities, targets, held, friction, close, impulses):
    """Sweep over the points until no velocity changes by more than `close` [m/s]; the nodes' velocities are changed.

    points (k,) : rows of local (n, a) and weights (n, a, d). nodes, masses (m,). velocities (all nodes, 4) [m/s].
    targets (k,) : least normal velocity [m/s]. held (k,) : whether it is also the largest. impulses (k, d) : [N s],
    written.
    """
    last = weights.shape[2] - 1
    for _sweep in range(MOST_SWEEPS):
        most = 0.0
        for k in range(points.shape[0]):
            s = points[k]
            response, rub_response, v, u, w = 0.0, 0.0, 0.0, 0.0, 0.0
            for a in range(local.shape[1]):
                m, n = local[s, a], nodes[local[s, a]]
                normal, tangent = weights[s, a, last], weights[s, a, 0]
                response += normal * normal / masses[m]
                rub_response += tangent * tangent / masses[m]
                v += normal * velocities[n, last]
                u += tangent * velocities[n, 0]
                w += weights[s, a, 1] * velocities[n, 1]
            pushed = impulses[k, last] + (targets[k] - v) / response
            pushed = pushed if held[k] else max(pushed, 0.0)
            change = pushed - impulses[k, last]
            impulses[k, last] = pushed
            along, across = 0.0, 0.0
            if friction > 0.0:
                along = impulses[k, 0] - u / rub_response
                across = impulses[k, 1] - w / rub_response if last == 2 else 0.0
                size, limit = math.sqrt(along * along + across * across), friction * max(pushed, 0.0)
                share = limit / size if size > limit else 1.0
                along, across = share * along, share * across
                impulses[k, 0], along = along, along - impulses[k, 0]
                if last == 2:
                    impulses[k, 1], across = across, across - impulses[k, 1]
            for a in range(local.shape[1]):
                n, over = nodes[local[s, a]], 1.0 / masses[local[s, a]]
                velocities[n, last] += weights[s, a, last] * over * change
                velocities[n, 0] += weights[s, a, 0] * over * along
                if last == 2:
                    velocities[n, 1] += weights[s, a, 1] * over * across
            most = max(most, abs(change) * response, (abs(along) + abs(across)) * rub_response)
        if most <= close:
            break


class ReferenceContact:
    """The wall, the points of the body's rim, and their memory of having touched it.

    Parameters
    ----------
    wall : kind and friction. rim : all faces of the rim.
    """

    def __init__(self, wall: Wall, rim: Surface) -> None:
        self._wall, self._rim = wall, rim
        self.touched = np.zeros(len(rim.reference_points), dtype=np.bool_)
        self._grid: Grid | None = None

    def measure(
        self, background: Background, positions: np.ndarray, deformation_gradient: np.ndarray
    ) -> None:
        """Measure the heights of the points above the wall."""
        if self._grid is not background.grid:
            self._grid, self._anchors = background.grid, background.anchors(self._rim.reference_points)
        self._heights = self._rim.points(positions, deformation_gradient)[:, -1]
        if self._wall.kind == PLANE:
            self.touched |= self._heights <= TOUCHING * background.cell_size
        self._near = np.flatnonzero((self._heights <= NEAR * background.cell_size) | self.touched)

    def meet(self, background: Background, dt: float) -> Push:
        """Stop what would pass the wall within dt [s]."""
        anchors, near = self._anchors, self._near
        axes = range(anchors.weights.shape[2])
        held = self.touched[near]
        targets = np.where(held, 0.0, -np.maximum(self._heights[near], 0.0) / dt)
        found = [anchors.after(axis)[near] for axis in axes]
        if not (held | (found[-1] < targets)).any():
            return Push()
        impulses = np.zeros((len(near), len(axes)))
        close = CLOSE * max(float(np.abs(velocity).max()) for velocity in found)
        press(
            near, anchors.local, anchors.weights, anchors.nodes, anchors.masses, anchors.velocities, targets, held,
            self._wall.friction, close, impulses,
        )  # fmt: skip
        reached = [anchors.after(axis)[near] for axis in axes]
        energies = [0.5 * float((impulses[:, a] * (found[a] + reached[a])).sum()) for a in axes]
        works = [0.5 * float((impulses[:, a] * (anchors.before(a)[near] + reached[a])).sum()) for a in axes]
        return Push(float(impulses[:, -1].sum()), works[-1], sum(works[:-1]), sum(energies))

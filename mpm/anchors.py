"""Points of the body's surface held in the grid: where loads and supports act on the nodes round them."""

from collections.abc import Sequence

import numpy as np

from core_models.compilation import kernel
from core_models.errors import RunFailure
from mpm.geometries import dimension_of, stand
from mpm.grid import FORCE, MASS, RECORD, VELOCITY, node_at
from mpm.interpolation import reach
from mpm.interpolation.cpdi import ConvectedDomain
from mpm.interpolation.gimp import UniformGimp
from mpm.interpolation.linear import LinearHat
from mpm.tile import STENCIL, WEIGHTS, put_stencil


def point_shape(shape):
    """The interpolation of a point without size."""
    return LinearHat() if isinstance(shape, UniformGimp | ConvectedDomain) else shape


@kernel
def hold(first, last, stencil, geometry, shape, grid, points, nodes, weights):
    """Nodes along each axis (k, d, reach), counted from base, that points (k, d) [m] reach, and their weights."""
    for p in range(first, last):
        i, j, k, t = stand(geometry, shape, grid, points, p)
        put_stencil(stencil, geometry, shape, p, t, grid.over_h)
        begin = (int(i), int(j), int(k))
        for axis in range(dimension_of(geometry)):
            for node in range(reach(shape)):
                nodes[p, axis, node] = begin[axis] + node
                weights[p, axis, node] = stencil[WEIGHTS + 4 * node + axis]


@kernel
def number_nodes(geometry, grid, nodes, numbers):
    """Numbers (m,) of nodes (m, 3), counted from base; -1 for those without mass."""
    for m in range(nodes.shape[0]):
        number = node_at(geometry, grid, nodes[m, 0], nodes[m, 1], nodes[m, 2])
        if number >= 0 and not grid.nodes[RECORD * number + MASS] > 0.0:
            number = -1
        numbers[m] = number


class Anchors:
    """Points (k, d) and the nodes that carry them.

    Nodes beyond a symmetry plane are taken for their images, components normal to it with the opposite sign. Nodes
    without mass, which the surface may reach a little earlier than the particles do, leave their weight to the others.

    Parameters
    ----------
    geometry, shape, grid : of the background. pairs : (axis, node beyond, image) of its symmetry planes.
    points : positions (k, d) [m].

    nodes : (m,) numbers of the nodes. masses : (m,) [kg]. velocities : (..., 4) of all nodes after the forces [m/s].
    local (k, a) : places in `nodes` of those that each point reaches. weights (k, a, d) : theirs along each axis.
    """

    def __init__(
        self, geometry, shape, grid, pairs: Sequence[tuple[int, int, int]], points: np.ndarray
    ) -> None:
        shape = point_shape(shape)
        k, d = points.shape
        along = np.empty((k, d, reach(shape)), dtype=np.int64)
        one_by_one = np.empty((k, d, reach(shape)))
        hold(0, k, np.zeros(STENCIL), geometry, shape, grid, points, along, one_by_one)
        nodes, weights = np.zeros((k, 1, 3), dtype=np.int64), np.ones((k, 1))
        for axis in range(d):
            nodes = np.repeat(nodes, reach(shape), axis=1)
            nodes[:, :, axis] = np.tile(along[:, axis], (1, weights.shape[1]))
            weights = (weights[:, :, None] * one_by_one[:, axis, None, :]).reshape(k, -1)
        signs = np.ones((*weights.shape, d))
        for axis, beyond, image in pairs:
            mirrored = nodes[:, :, axis] == beyond
            nodes[mirrored, axis] = image
            signs[mirrored, axis] *= -1.0
        numbers = np.empty(weights.size, dtype=np.int64)
        number_nodes(geometry, grid, nodes.reshape(-1, 3), numbers)
        numbers = numbers.reshape(weights.shape)
        weights = np.where(numbers >= 0, weights, 0.0)
        total = weights.sum(axis=1, keepdims=True)
        if not (total > 0.0).all():
            place = ", ".join(f"{x:.4g}" for x in points[int(total.argmin())])
            raise RunFailure(
                f"the loaded surface at ({place}) m has no particle within reach: the body has come apart there; "
                "use a finer mesh of particles, or take the load off"
            )
        self.nodes, local = np.unique(numbers[numbers >= 0], return_inverse=True)
        self.local = np.zeros(weights.shape, dtype=np.int64)
        self.local[numbers >= 0] = local
        self.weights = signs * (weights / total)[:, :, None]
        self._records = grid.nodes.reshape(-1, RECORD)
        self.velocities = grid.after.reshape(-1, VELOCITY)
        self.masses = self._records[self.nodes, MASS]

    def __len__(self) -> int:
        """Number of points."""
        return len(self.local)

    def before(self, axis: int) -> np.ndarray:
        """The grid's velocity along an axis before the forces at the points (k,) [m/s]."""
        return self._interpolate(axis, self._records[self.nodes, axis])

    def after(self, axis: int) -> np.ndarray:
        """The grid's velocity along an axis after the forces at the points (k,) [m/s]."""
        return self._interpolate(axis, self.velocities[self.nodes, axis])

    def jump(self, axis: int) -> float:
        """Kinetic energy of the change of velocity along an axis that these nodes have undergone [J]."""
        change = self.velocities[self.nodes, axis] - self._records[self.nodes, axis]
        return 0.5 * float((self.masses * change * change).sum())

    def response(self, axis: int, impulses: np.ndarray) -> np.ndarray:
        """Change of velocity along an axis (k,) [m/s] at the points that impulses there (k,) [N s] would make."""
        return self._interpolate(axis, self._spread(axis, impulses) / self.masses)

    def push(self, axis: int, impulses: np.ndarray) -> None:
        """Change the velocity after the forces by impulses along an axis (k,) [N s] at the points."""
        self.velocities[self.nodes, axis] += self._spread(axis, impulses) / self.masses

    def load(self, axis: int, forces: np.ndarray) -> None:
        """Add forces along an axis (k,) [N] at the points to those on the nodes."""
        self._records[self.nodes, FORCE + axis] += self._spread(axis, forces)

    def even(self, values: np.ndarray) -> np.ndarray:
        """Interpolate values of all nodes of the grid, even across symmetry planes, to the points (k,)."""
        return (np.abs(self.weights[:, :, 0]) * values[self.nodes][self.local]).sum(axis=1)

    def spread_evenly(self, values: np.ndarray) -> np.ndarray:
        """Spread what the points hold (k,) over the nodes (m,), the same way on both sides of symmetry planes."""
        shares = (np.abs(self.weights[:, :, 0]) * values[:, None]).ravel()
        return np.bincount(self.local.ravel(), weights=shares, minlength=len(self.nodes))

    def _interpolate(self, axis: int, values: np.ndarray) -> np.ndarray:
        return (self.weights[:, :, axis] * values[self.local]).sum(axis=1)

    def _spread(self, axis: int, values: np.ndarray) -> np.ndarray:
        shares = (self.weights[:, :, axis] * values[:, None]).ravel()
        return np.bincount(self.local.ravel(), weights=shares, minlength=len(self.nodes))

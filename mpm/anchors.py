"""Points of the body's surface held in the grid: where loads and supports act on the nodes round them.

A point x is held by the nodes that it reaches itself, with weights N_i(x), or through its particle x_p:

    w_i = N_i(x - b) + b . grad N_i(x_p)

which have the same sum, 1, and the same first moment, so force and torque are those at x. With b the thickness of the
particle's domain, its volume over its face, a force F then acts on it like the stress F b / V, and goes on from the
middle of the body: a uniform stress is in balance with it node by node. N_i(x) alone is not fit for forces: a surface
enters a layer of cells before its particles do, and a finite force on a node with next to no mass would strain them
without bound.
Source: Liang, Given & Soga, Comput. Methods Appl. Mech. Eng. 404 (2023) 115785 (virtual stress), here in one layer of
particles.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from core_models.compilation import kernel
from core_models.errors import RunFailure
from mpm.geometries import dimension_of, stand
from mpm.grid import FORCE, MASS, RECORD, VELOCITY, node_at
from mpm.interpolation import reach
from mpm.interpolation.catalogue import Interpolation
from mpm.interpolation.cpdi import ConvectedDomain, corner_gradients
from mpm.interpolation.gimp import UniformGimp
from mpm.interpolation.linear import LinearHat
from mpm.tile import SLOPES, STENCIL, WEIGHTS, put_stencil


def point_shape(shape):
    """The interpolation of a point without size."""
    return LinearHat() if isinstance(shape, UniformGimp | ConvectedDomain) else shape


def particle_shape(shape, particles: np.ndarray):
    """The interpolation of some of the particles, numbered anew."""
    if isinstance(shape, UniformGimp):
        return UniformGimp(shape.halves[particles])
    if isinstance(shape, ConvectedDomain):
        return ConvectedDomain(shape.half_edges[particles], shape.gradient[particles])
    return shape


@kernel
def hold(first, last, stencil, geometry, shape, grid, points, nodes, weights, gradients):
    """Nodes along each axis (k, d, reach), from base, that points (k, d) [m] reach, their weights and slopes [1/m]."""
    for p in range(first, last):
        i, j, k, t = stand(geometry, shape, grid, points, p)
        put_stencil(stencil, geometry, shape, p, t, grid.over_h)
        begin = (int(i), int(j), int(k))
        for axis in range(dimension_of(geometry)):
            for node in range(reach(shape)):
                nodes[p, axis, node] = begin[axis] + node
                weights[p, axis, node] = stencil[WEIGHTS + 4 * node + axis]
                gradients[p, axis, node] = stencil[SLOPES + 4 * node + axis]


@kernel
def number_nodes(geometry, grid, nodes, numbers):
    """Numbers (m,) of nodes (m, 3), counted from base; -1 for those without mass."""
    for m in range(nodes.shape[0]):
        number = node_at(geometry, grid, nodes[m, 0], nodes[m, 1], nodes[m, 2])
        if number >= 0 and not grid.nodes[RECORD * number + MASS] > 0.0:
            number = -1
        numbers[m] = number


def reached(geometry, shape, grid, points: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Nodes (k, a, 3), counted from base, that points (k, d) [m] reach, weights (k, a) and slopes (k, a, d) [1/m]."""
    k, d = points.shape
    along = np.empty((k, d, reach(shape)), dtype=np.int64)
    weights, slopes = np.empty((2, k, d, reach(shape)))
    hold(0, k, np.zeros(STENCIL), geometry, shape, grid, points, along, weights, slopes)
    nodes = np.zeros((k, *(reach(shape),) * d, 3), dtype=np.int64)
    product, products = np.ones((k, *(1,) * d)), [np.ones((k, *(1,) * d)) for _axis in range(d)]
    for axis in range(d):
        across = (k, *(reach(shape) if other == axis else 1 for other in range(d)))
        nodes[..., axis] = along[:, axis].reshape(across)
        product = product * weights[:, axis].reshape(across)
        for other in range(d):
            factor = slopes if other == axis else weights
            products[other] = products[other] * factor[:, axis].reshape(across)
    return nodes.reshape(k, -1, 3), product.reshape(k, -1), np.stack(products, axis=-1).reshape(k, -1, d)


def sloping(geometry, shape, grid, points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Nodes (k, a, 3), from base, that particles at points (k, d) [m] reach, and slopes of weights (k, a, d) [1/m]."""
    if not isinstance(shape, ConvectedDomain):
        nodes, _weights, slopes = reached(geometry, shape, grid, points)
        return nodes, slopes
    k, d = points.shape
    offsets, factors = corner_gradients(shape)
    nodes, weights, _slopes = reached(geometry, LinearHat(), grid, (points[:, None] + offsets).reshape(-1, d))
    slopes = weights.reshape(k, 2**d, -1, 1) * factors[:, :, None]
    return nodes.reshape(k, -1, 3), slopes.reshape(k, -1, d)


class Through(NamedTuple):
    """The particles that surface points belong to.

    particles : (k, d) [m] where they are. thickness : (k, d) [m], b of the module's formula. shape : their
    interpolation.
    """

    particles: np.ndarray
    thickness: np.ndarray
    shape: Interpolation


class Anchors:
    """Points (k, d) and the nodes that carry them.

    Nodes beyond a symmetry plane are taken for their images, components normal to it with the opposite sign. Nodes
    without mass, which the surface may reach a little earlier than the particles do, leave their weight to the others.

    Parameters
    ----------
    geometry, grid : of the background. shape : interpolation of a point. pairs : (axis, node beyond, image) of the
    symmetry planes. points : positions (k, d) [m]. through : `Through` the particles, or None.

    nodes : (m,) numbers of the nodes. masses : (m,) [kg]. velocities : (..., 4) of all nodes after the forces [m/s].
    local (k, a) : places in `nodes` of those that each point reaches. weights (k, a, d) : theirs along each axis.
    """

    def __init__(
        self,
        geometry,
        shape,
        grid,
        pairs: Sequence[tuple[int, int, int]],
        points: np.ndarray,
        through: Through | None = None,
    ) -> None:
        d = points.shape[1]
        if through is None:
            nodes, weights, _slopes = reached(geometry, shape, grid, points)
        else:
            inner, weights, _slopes = reached(geometry, shape, grid, points - through.thickness)
            outer, slopes = sloping(geometry, through.shape, grid, through.particles)
            nodes = np.concatenate([inner, outer], axis=1)
            weights = np.concatenate([weights, np.einsum("kai,ki->ka", slopes, through.thickness)], axis=1)
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

    def response(self, axis: int, impulses: np.ndarray) -> np.ndarray:
        """Change of velocity along an axis (k,) [m/s] at the points that impulses there (k,) [N s] would make."""
        return self._interpolate(axis, self._spread(axis, impulses) / self.masses)

    def own_response(self, axis: int) -> np.ndarray:
        """Change of velocity along an axis (k,) [m/s] at each point that an impulse of 1 N s there would make."""
        weights = self.weights[:, :, axis]
        return (weights * weights / self.masses[self.local]).sum(axis=1)

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

"""A thread's scratch: the nodes round one block as a dense box, and the weights of one particle.

What a block's particles do to the grid happens in a tile that stays in the cache; the tile then is added to the
blocks it covers.
"""

from typing import NamedTuple

import numpy as np

from core_models.compilation import inside_kernel
from core_models.dispatch import generic
from mpm.geometries import dimension_of
from mpm.grid import EDGE, FORCE, RECORD, VELOCITY, node_in
from mpm.interpolation import half_size, middle, moments, reach, slopes, weights
from mpm.lanes import add_to, load, store

WIDEST = EDGE + 4  # nodes along the edge of the largest tile
# First number of each table of a stencil; four numbers per node along an axis.
WEIGHTS, SLOPES, MOMENTS, OFFSETS, LEVERS = 0, 16, 32, 48, 64

STENCIL = 80


class Scratch(NamedTuple):
    """tile, second : nodes round a block, flat. stencil : the tables of a particle's nodes along the axes, flat."""

    tile: np.ndarray
    second: np.ndarray
    stencil: np.ndarray


def make_scratch(dimension: int) -> Scratch:
    """Scratch for one thread."""
    nodes = WIDEST**dimension
    return Scratch(np.zeros(RECORD * nodes), np.zeros(VELOCITY * nodes), np.zeros(STENCIL))


@inside_kernel
def edge_of(shape):
    """Nodes along the edge of a tile."""
    return EDGE - 1 + reach(shape)


@inside_kernel
def depth_of_tile(geometry, shape):
    """Nodes of a tile along the third axis."""
    return 1 if dimension_of(geometry) == 2 else edge_of(shape)


@inside_kernel
def place_in_tile(shape, corner, i, j, k):
    """Number of a node in the tile whose first node is `corner`."""
    edge = edge_of(shape)
    return (int(i) - corner[0]) + edge * ((int(j) - corner[1]) + edge * (int(k) - corner[2]))


@inside_kernel
def clear_tile(geometry, shape, tile, size):
    """Set all records of a tile, of `size` numbers each, to 0."""
    edge = edge_of(shape)
    for place in range(size * edge * edge * depth_of_tile(geometry, shape)):
        tile[np.uint64(place)] = 0.0


@inside_kernel
def add_tile(geometry, shape, grid, home, tile):
    """Add the records of a tile to the grid's nodes."""
    nodes, edge = grid.nodes, edge_of(shape)
    source = 0
    for k in range(depth_of_tile(geometry, shape)):
        for j in range(edge):
            for i in range(edge):
                target = RECORD * node_in(geometry, grid, home, i, j, k)
                add_to(nodes, target, load(tile, source))
                add_to(nodes, target + FORCE, load(tile, source + FORCE))
                source += RECORD


@inside_kernel
def add_velocities(geometry, shape, grid, home, tile, target):
    """Add a tile of records of four numbers to those of the nodes in a flat array."""
    edge = edge_of(shape)
    source = 0
    for k in range(depth_of_tile(geometry, shape)):
        for j in range(edge):
            for i in range(edge):
                add_to(target, VELOCITY * node_in(geometry, grid, home, i, j, k), load(tile, source))
                source += VELOCITY


@inside_kernel
def fetch_tile(geometry, shape, grid, home, array, size, tile):
    """Fill a tile of velocities from a flat array with records of `size` numbers, of which it takes the first four."""
    edge = edge_of(shape)
    target = 0
    for k in range(depth_of_tile(geometry, shape)):
        for j in range(edge):
            for i in range(edge):
                store(tile, target, load(array, size * node_in(geometry, grid, home, i, j, k)))
                target += VELOCITY


@generic
def fetch_second(second, geometry, shape, grid, home, size, tile):
    """`fetch_tile` of a second field, if there is one."""


@fetch_second.register(np.ndarray)
def _(second, geometry, shape, grid, home, size, tile):
    fetch_tile(geometry, shape, grid, home, second, size, tile)


@fetch_second.register(type(None))
def _(second, geometry, shape, grid, home, size, tile):
    return


@inside_kernel
def put(stencil, table, values, scale):
    """Write a tuple of lanes, one per node, times a number, to a table."""
    for node in range(len(values)):
        store(stencil, table + 4 * node, values[node] * scale)


@inside_kernel
def put_offsets(stencil, shape, t, h):
    """Write the distances from the particle to its nodes, and their products with the weights [m]."""
    for node in range(reach(shape)):
        offset = (node - middle(shape) - t) * h
        store(stencil, OFFSETS + 4 * node, offset)
        store(stencil, LEVERS + 4 * node, load(stencil, WEIGHTS + 4 * node) * offset)


@inside_kernel
def put_stencil(stencil, geometry, shape, p, t, over_h):
    """Write weights and slopes [1/m] of particle p."""
    half = half_size(shape, p, over_h)
    put(stencil, WEIGHTS, weights(shape, t, half), 1.0)
    put(stencil, SLOPES, slopes(shape, t, half), over_h)
    flatten(geometry, stencil, WEIGHTS, 1.0)
    flatten(geometry, stencil, SLOPES, 0.0)


@generic
def put_moments(affine, stencil, geometry, shape, p, t, over_h):
    """Write the moments [1/m] of particle p, if it has an affine velocity."""


@put_moments.register(np.ndarray)
def _(affine, stencil, geometry, shape, p, t, over_h):
    put(stencil, MOMENTS, moments(shape, t, half_size(shape, p, over_h)), over_h)
    flatten(geometry, stencil, MOMENTS, 0.0)


@put_moments.register(type(None))
def _(affine, stencil, geometry, shape, p, t, over_h):
    return


@inside_kernel
def flatten(geometry, stencil, table, value):
    """In two dimensions, what stands in a table for the one layer of nodes along the third axis."""
    if dimension_of(geometry) == 2:
        stencil[table + 2] = value

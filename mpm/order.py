"""Which block each particle is at home in, particles ordered by block, and the blocks that need storage.

A particle's home is the block of the first node that it reaches. All its nodes then lie in that block or in the next
one along each axis: blocks of one colour (2 x 2 (x 2) colours, by even and odd numbers) share no node.
"""

from typing import NamedTuple

import numpy as np

from core_models.compilation import CHUNK, inside_kernel, kernel
from mpm.geometries import dimension_of, stand
from mpm.grid import EDGE, Grid

SAME, MOVED = -1, -2  # what `locate_particles` says of a chunk, unless it names a particle outside the box


class Order(NamedTuple):
    """particles[start[b] : start[b + 1]] are at home in block b of the table.

    keys : (n,) block of each particle. seen : per chunk of particles, written by `locate_particles`.
    colours : (9,) first of the grid's homes of each colour.
    """

    particles: np.ndarray
    keys: np.ndarray
    start: np.ndarray
    seen: np.ndarray
    colours: np.ndarray


def make_order(particles: int, grid: Grid) -> Order:
    """Room for the order of particles on a grid."""
    return Order(
        np.zeros(
            particles, dtype=np.uint32
        ),  # unsigned: kernels need not ask whether they count from the end
        np.full(particles, -1, dtype=np.int32),
        np.zeros(len(grid.table) + 1, dtype=np.int32),
        np.zeros(-(-particles // CHUNK), dtype=np.int64),
        np.zeros(9, dtype=np.int64),
    )


@kernel
def locate_particles(first, last, geometry, shape, grid, bounds, positions, order):
    """Find the home of the particles of chunks first ... last-1.

    bounds : (d, 2) lowest and highest coordinates where particles may be [m].
    order.seen of a chunk becomes MOVED if one of them has another home than before, else SAME; or the number of a
    particle that is out of bounds or outside the box.
    """
    low, blocks, keys = grid.low, grid.shape, order.keys
    for chunk in range(first, last):
        order.seen[chunk] = SAME
        for p in range(chunk * CHUNK, min((chunk + 1) * CHUNK, positions.shape[0])):
            if not is_within(geometry, bounds, positions, p):
                order.seen[chunk] = p
                break
            i, j, k, _ = stand(geometry, shape, grid, positions, p)
            i, j, k = i - EDGE * low[0], j - EDGE * low[1], k - EDGE * low[2]
            if not (
                is_inside(i, blocks[0])
                and is_inside(j, blocks[1])
                and is_inside_depth(geometry, k, blocks[2])
            ):
                order.seen[chunk] = p
                break
            key = (int(i) >> 2) + blocks[0] * ((int(j) >> 2) + blocks[1] * (int(k) >> 2))
            if key != keys[p]:
                keys[p] = key
                order.seen[chunk] = MOVED


@inside_kernel
def is_within(geometry, bounds, positions, p):
    """Whether a particle is within bounds; no for what is not a number."""
    within = True
    for axis in range(dimension_of(geometry)):
        within = within and bounds[axis, 0] <= positions[p, axis] <= bounds[axis, 1]
    return within


@inside_kernel
def is_inside(node, blocks):
    """Whether a node's block and the next one are in a box of so many blocks; no for what is not a number."""
    return node >= 0.0 and node < EDGE * (blocks - 1)


@inside_kernel
def is_inside_depth(geometry, node, blocks):
    """The same along the third axis."""
    return dimension_of(geometry) == 2 or is_inside(node, blocks)


@kernel
def sort_particles(order):
    """Order the particles by home, those of one home by number (a counting sort)."""
    keys, start, particles = order.keys, order.start, order.particles
    for block in range(start.shape[0]):
        start[block] = 0
    for p in range(keys.shape[0]):
        start[keys[p] + 1] += 1
    for block in range(start.shape[0] - 1):
        start[block + 1] += start[block]
    for p in range(keys.shape[0]):
        particles[start[keys[p]]] = p
        start[keys[p]] += 1
    for block in range(start.shape[0] - 1, 0, -1):
        start[block] = start[block - 1]
    start[0] = 0


@kernel
def lay_out(geometry, grid, order):
    """List the homes colour by colour and number the blocks that need storage; returns how many there are."""
    table, homes, start, shape = grid.table, grid.homes, order.start, grid.shape
    for place in range(table.shape[0]):
        table[place] = -1
    depth = 2 if dimension_of(geometry) == 3 else 1
    count, colour = 0, 0
    for z in range(depth):
        for y in range(2):
            for x in range(2):
                order.colours[colour] = count
                colour += 1
                for k in range(z, shape[2], 2):
                    for j in range(y, shape[1], 2):
                        for i in range(x, shape[0], 2):
                            home = i + shape[0] * (j + shape[1] * k)
                            if start[home + 1] > start[home]:
                                homes[count] = home
                                count += 1
                                mark(table, shape, home, depth)
    for rest in range(colour, order.colours.shape[0]):
        order.colours[rest] = count
    blocks = 0
    for place in range(table.shape[0]):
        if table[place] == 0:
            table[place] = blocks
            blocks += 1
    return blocks


@inside_kernel
def mark(table, shape, home, depth):
    """Mark the blocks that the particles of one home reach."""
    for k in range(depth):
        for j in range(2):
            for i in range(2):
                table[home + i + shape[0] * (j + shape[1] * k)] = 0

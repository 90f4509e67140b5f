"""Which block each particle is at home in, particles ordered by block, and the blocks that need storage.

A particle's home is the block of the first node that it reaches. All its nodes then lie in that block or in the next
one along each axis: blocks of one colour (2 x 2 (x 2) colours, by even and odd numbers) share no node.
"""

from typing import NamedTuple

import numpy as np

from core_models.compilation import CHUNK, inside_kernel, kernel
from core_models.geometry import Geometry
from mpm.geometries import dimension_of, stand
from mpm.grid import EDGE, Grid

HOMES, STORED = 0, 1
SAME, MOVED = -1, -2  # what `locate_particles` says of a chunk, unless it names a particle outside the box


class Order(NamedTuple):
    """particles[start[b] : stop[b]] are at home in block b of the table; blocks that are no homes have stop = 0.

    keys : (n,) block of each particle. seen : per chunk of particles, written by `locate_particles`.
    homes, stored : blocks that are homes, and blocks with storage, in order, then what is left of earlier ones;
    sizes : (2,) how many there are now. colours : (9,) first of the grid's homes of each colour.
    """

    particles: np.ndarray
    keys: np.ndarray
    start: np.ndarray
    stop: np.ndarray
    seen: np.ndarray
    homes: np.ndarray
    stored: np.ndarray
    sizes: np.ndarray
    colours: np.ndarray


def make_order(particles: int, grid: Grid) -> Order:
    """Room for the order of particles on a grid."""
    return Order(
        # Unsigned: kernels need not ask whether they count from the end.
        particles=np.zeros(particles, dtype=np.uint32),
        keys=np.full(particles, -1, dtype=np.int32),
        start=np.zeros(len(grid.table), dtype=np.int32),
        stop=np.zeros(len(grid.table), dtype=np.int32),
        seen=np.zeros(-(-particles // CHUNK), dtype=np.int64),
        homes=np.zeros_like(grid.homes),
        stored=np.zeros_like(grid.stored),
        sizes=np.zeros(2, dtype=np.int64),
        colours=np.zeros(9, dtype=np.int64),
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


def sort_particles(order: Order) -> None:
    """Order the particles by home, those of one home by number: a counting sort over the homes, however far apart."""
    list_homes(order)
    order.homes[: order.sizes[HOMES]].sort()
    put_in_order(order)


@kernel
def list_homes(order):
    """List the blocks that are homes, and count in `stop` the particles of each."""
    keys, stop, homes, sizes = order.keys, order.stop, order.homes, order.sizes
    for number in range(sizes[HOMES]):
        stop[homes[number]] = 0
    count = 0
    for p in range(keys.shape[0]):
        if stop[keys[p]] == 0:
            homes[count] = keys[p]
            count += 1
        stop[keys[p]] += 1
    sizes[HOMES] = count


@kernel
def put_in_order(order):
    """Put the particles in the order of the homes that `list_homes` has listed and counted."""
    keys, start, stop, particles = order.keys, order.start, order.stop, order.particles
    before = 0
    for number in range(order.sizes[HOMES]):
        home = order.homes[number]
        start[home] = before
        before += stop[home]
        stop[home] = start[home]
    for p in range(keys.shape[0]):
        particles[stop[keys[p]]] = p
        stop[keys[p]] += 1


def lay_out(geometry: Geometry, grid: Grid, order: Order) -> int:
    """List the homes colour by colour and number the blocks that need storage; returns how many there are."""
    list_blocks(geometry, grid, order)
    blocks = int(order.sizes[STORED])
    order.stored[:blocks].sort()
    grid.table[order.stored[:blocks]] = np.arange(blocks, dtype=np.int32)
    return blocks


@kernel
def list_blocks(geometry, grid, order):
    """List the homes colour by colour, and the blocks that their particles reach."""
    table, shape, stored, sizes = grid.table, grid.shape, order.stored, order.sizes
    for block in range(sizes[STORED]):
        table[stored[block]] = -1
    depth = 2 if dimension_of(geometry) == 3 else 1
    count, colour, blocks = 0, 0, 0
    for z in range(depth):
        for y in range(2):
            for x in range(2):
                order.colours[colour] = count
                colour += 1
                for number in range(sizes[HOMES]):
                    home = order.homes[number]
                    row, i = divmod(home, shape[0])
                    k, j = divmod(row, shape[1])
                    if i & 1 == x and j & 1 == y and k & 1 == z:
                        grid.homes[count] = home
                        count += 1
                        blocks = mark(table, stored, shape, home, depth, blocks)
    for rest in range(colour, order.colours.shape[0]):
        order.colours[rest] = count
    sizes[STORED] = blocks


@inside_kernel
def mark(table, stored, shape, home, depth, blocks):
    """Add the blocks that the particles of one home reach to the `blocks` listed so far; returns how many there are."""
    for k in range(depth):
        for j in range(2):
            for i in range(2):
                place = home + i + shape[0] * (j + shape[1] * k)
                if table[place] < 0:
                    table[place] = 0
                    stored[blocks] = place
                    blocks += 1
    return blocks

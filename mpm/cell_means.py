"""Means over the cells near a particle, at the corners of the cells: the projection of `mpm.dilatation`.

A thread's tile holds the corners of a home and of the blocks next to it. Corner i stands where node i has its lower
edge, half a cell off it, and is stored with it.
"""

import math

from core_models.compilation import inside_kernel, kernel
from mpm.geometries import dimension_of
from mpm.grid import EDGE, block_corner, node_in
from mpm.lanes import add_to, lanes

PAIR = 2  # numbers of a corner: sum of volumes, and of volumes times values
WIDE = 2 * EDGE  # corners along the edge of a tile


@inside_kernel
def along(geometry, grid, positions, p, axis, corner):
    """Lower corner of particle p's cell along an axis, counted from `corner`, and where the particle is in the cell."""
    if axis == dimension_of(geometry):
        return 0, 0.0
    x = (positions[p, axis] - grid.base[axis]) * grid.over_h
    lower = math.floor(x)
    return int(lower) - corner[axis], x - lower


@inside_kernel
def stand_in_cell(geometry, grid, positions, p, corner):
    """Place in a tile of the lowest corner of particle p's cell, and where the particle is in the cell, 0 ... 1."""
    i, x = along(geometry, grid, positions, p, 0, corner)
    j, y = along(geometry, grid, positions, p, 1, corner)
    k, z = along(geometry, grid, positions, p, 2, corner)
    return i + WIDE * (j + WIDE * k), x, y, z


@inside_kernel
def share(upper, x):
    """H of the upper or the lower corner at x along an axis."""
    return x if upper else 1.0 - x


@inside_kernel
def mean_at(geometry, tile, at, x, y, z):
    """(P a)_p from a tile of means."""
    mean = 0.0
    for c in range(dimension_of(geometry) - 1):
        for b in range(2):
            place = at + WIDE * (b + WIDE * c)
            mean += share(b, y) * share(c, z) * ((1.0 - x) * tile[place] + x * tile[place + 1])
    return mean


@inside_kernel
def fetch_means(geometry, grid, home, sums, tile):
    """Fill a tile with the means at the corners; 0 where no particle is near."""
    target = 0
    for k in range(WIDE if dimension_of(geometry) == 3 else 1):
        for j in range(WIDE):
            for i in range(WIDE):
                source = PAIR * node_in(geometry, grid, home, i, j, k)
                volume = sums[source]
                tile[target] = sums[source + 1] / volume if volume > 0.0 else 0.0
                target += 1


@kernel
def gather_means(
    first, last, scratch, geometry, shape, grid, order, offset, positions, volumes, values, sums
):
    """Add volumes (n,) [m^3], and volumes times values (n,), of the particles of some homes to the corners.

    first, last, offset : as in `mpm.to_grid`. sums : flat, two numbers per corner, stored like the nodes.
    """
    tile = scratch.tile
    for number in range(offset + first, offset + last):
        home = grid.homes[number]
        corner = block_corner(grid, home)
        for place in range(PAIR * WIDE ** dimension_of(geometry)):
            tile[place] = 0.0
        for place in range(order.start[home], order.stop[home]):
            p = order.particles[place]
            at, x, y, z = stand_in_cell(geometry, grid, positions, p, corner)
            volume, value = volumes[p], values[p]
            for c in range(dimension_of(geometry) - 1):
                for b in range(2):
                    part = volume * share(b, y) * share(c, z)
                    high = part * x
                    low = part - high
                    to = PAIR * (at + WIDE * (b + WIDE * c))
                    add_to(tile, to, lanes(low, low * value, high, high * value))
        source = 0
        for k in range(WIDE if dimension_of(geometry) == 3 else 1):
            for j in range(WIDE):
                for i in range(WIDE):
                    target = PAIR * node_in(geometry, grid, home, i, j, k)
                    sums[target] += tile[source]
                    sums[target + 1] += tile[source + 1]
                    source += PAIR

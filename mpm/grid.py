"""Background grid of the axisymmetric (r, z) plane.

Nodes lie half a cell off the axis and off the wall: r_i = (i - 1/2) h, z_j = (j - GHOSTS + 1/2) h. The node column
i = 0 is the mirror image of column 1 in the axis, row GHOSTS - 1 that of row GHOSTS in the wall plane z = 0, so that
the quadratic B-splines keep their full support, and reproduce linear fields, right up to axis and wall.
"""

import math
from typing import NamedTuple

import numpy as np

from core_models.compilation import inside_kernel, kernel

GHOSTS = 2  # rows below the wall
STRIPE = 4  # rows of cells in a stripe; wider than the stencil, so that every second stripe can be filled in parallel
MASS, MOMENTUM_R, MOMENTUM_Z, FORCE_R, FORCE_Z = 0, 1, 2, 3, 4


class Grid(NamedTuple):
    """Arrays of the grid: sums (rows, columns, 5) are mass, momentum and force; velocities before and after forces.

    first, last : (rows,) columns of each row that particles reach; first > last where there are none. Nothing else
    is touched.
    """

    sums: np.ndarray
    before: np.ndarray
    after: np.ndarray
    first: np.ndarray
    last: np.ndarray


def make_grid(cell_size: float, radius: float, height: float) -> Grid:
    """Grid that reaches to `radius` and `height` [m]; it grows when particles come near its end."""
    columns = math.ceil(radius / cell_size) + 4
    rows = math.ceil(height / cell_size) + GHOSTS + 4
    return Grid(
        np.zeros((rows, columns, 5)),
        np.zeros((rows, columns, 2)),
        np.zeros((rows, columns, 2)),
        np.zeros(rows, dtype=np.int64),
        np.zeros(rows, dtype=np.int64),
    )


@inside_kernel
def stencil(x, over_h, offset):
    """First of the three nodes that a coordinate reaches, and its distance to the middle one in cells.

    offset : number of the first node for a coordinate in the cell 0 ... h (0 along r, GHOSTS - 1 along z).
    """
    scaled = x * over_h
    cell = math.floor(scaled)
    return int(cell) + offset, scaled - cell - 0.5


@inside_kernel
def weights(d):
    """Quadratic B-spline weights of the three nodes at distance d in [-1/2, 1/2] cells from the middle one."""
    return 0.5 * (0.5 - d) * (0.5 - d), 0.75 - d * d, 0.5 * (0.5 + d) * (0.5 + d)


@inside_kernel
def slopes(d, over_h):
    """Derivatives of the weights [1/m]."""
    return (d - 0.5) * over_h, -2.0 * d * over_h, (d + 0.5) * over_h


@kernel
def sort_particles(positions, over_h, sums, first, last, stripe_start, order):
    """Order particles by stripe and find the columns that each node row needs; clears those nodes.

    positions : (n, 2) [m]. first, last : (rows,), written. stripe_start : (stripes + 1,), order : (n,), written.
    Returns the number of the first particle outside the grid, or -1.
    """
    rows, columns = sums.shape[0], sums.shape[1]
    for row in range(rows):
        first[row] = columns
        last[row] = -1
    stripe_start[:] = 0
    for p in range(positions.shape[0]):
        if not (math.isfinite(positions[p, 0]) and math.isfinite(positions[p, 1])):
            return p
        column = stencil(positions[p, 0], over_h, 0)[0]
        row = stencil(positions[p, 1], over_h, GHOSTS - 1)[0]
        if column < 0 or row < 0 or column + 2 >= columns or row + 2 >= rows:
            return p
        first[row] = min(first[row], column)
        last[row] = max(last[row], column)
        stripe_start[row // STRIPE + 1] += 1
    for row in range(rows - 1, -1, -1):
        for below in range(max(row - 2, 0), row):
            first[row] = min(first[row], first[below])
            last[row] = max(last[row], last[below])
        last[row] = last[row] + 2 if last[row] >= 0 else -1
    for stripe in range(stripe_start.shape[0] - 1):
        stripe_start[stripe + 1] += stripe_start[stripe]
    fill = stripe_start.copy()
    for p in range(positions.shape[0]):
        row = stencil(positions[p, 1], over_h, GHOSTS - 1)[0]
        stripe = row // STRIPE
        order[fill[stripe]] = p
        fill[stripe] += 1
    for row in range(rows):
        for column in range(first[row], last[row] + 1):
            for k in range(5):
                sums[row, column, k] = 0.0
    return -1

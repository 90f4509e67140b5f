"""Background grid of the axisymmetric (r, z) plane.

Nodes lie half a cell off the axis and off the wall: r_i = (i - 1/2) h, z_j = (j - GHOSTS + 1/2) h. The node column
i = 0 is the mirror image of column 1 in the axis, row GHOSTS - 1 that of row GHOSTS in the wall plane z = 0, so that
the quadratic B-splines keep their full support, and reproduce linear fields, right up to axis and wall.
"""

import math
from typing import NamedTuple

import numpy as np

from core_models.compilation import inside_kernel, kernel
from core_models.errors import SceneError

GHOSTS = 2  # rows below the wall
MOST_NODES = 30_000_000  # some 2 GB
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
    """Grid that reaches to `radius` and `height` [m]; it grows when particles come near its end.

    Raises SceneError for a grid that no memory would hold.
    """
    columns = math.ceil(radius / cell_size) + 4
    rows = math.ceil(height / cell_size) + GHOSTS + 4
    if rows * columns > MOST_NODES:
        raise SceneError(
            f"a grid of {rows} x {columns} nodes for cells of {cell_size:.3g} m is too large: "
            f"give larger cells (at most {MOST_NODES:.0e} nodes)"
        )
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
def cell_of(x, over_h):
    """Number of the cell of a coordinate, counted from 0 at the axis or the wall, by the rule of `stencil`."""
    return math.floor(x * over_h)


@inside_kernel
def weights(d):
    """Quadratic B-spline weights of the three nodes at distance d in [-1/2, 1/2] cells from the middle one."""
    return 0.5 * (0.5 - d) * (0.5 - d), 0.75 - d * d, 0.5 * (0.5 + d) * (0.5 + d)


@inside_kernel
def slopes(d, over_h):
    """Derivatives of the weights [1/m]."""
    return (d - 0.5) * over_h, -2.0 * d * over_h, (d + 0.5) * over_h


class Order(NamedTuple):
    """Particles by stripe of cells: particles[start[s] : start[s + 1]] are in stripe s.

    stripes : (n,) stripe of each particle. fill : (stripes + 1,) for the sorting itself.
    """

    particles: np.ndarray
    start: np.ndarray
    stripes: np.ndarray
    fill: np.ndarray


def make_order(particles: int, rows: int) -> Order:
    """Room for the order of particles on a grid with that many rows of nodes."""
    stripes = -(-rows // STRIPE)

    def integers(count: int) -> np.ndarray:
        return np.zeros(count, dtype=np.int64)

    return Order(integers(particles), integers(stripes + 1), integers(particles), integers(stripes + 1))


@kernel
def sort_particles(positions, over_h, grid, order):
    """Order particles by stripe, find the columns that each node row needs and clear those nodes.

    positions : (n, 2) [m]. Returns the number of the first particle outside the grid, or -1.
    """
    first, last, start = grid.first, grid.last, order.start
    rows, columns = grid.sums.shape[0], grid.sums.shape[1]
    for row in range(rows):
        first[row] = columns
        last[row] = -1
    for stripe in range(start.shape[0]):
        start[stripe] = 0
    low, high, count, current = columns, -1, 0, 0
    for p in range(positions.shape[0]):
        r, z = cell_of(positions[p, 0], over_h), cell_of(positions[p, 1], over_h) + (GHOSTS - 1)
        if not (r >= 0.0 and z >= 0.0 and r < columns - 2 and z < rows - 2):
            return p
        column, row = int(r), int(z)
        if row != current:
            _note(first, last, start, current, low, high, count)
            low, high, count, current = columns, -1, 0, row
        low, high, count = min(low, column), max(high, column), count + 1
        order.stripes[p] = row // STRIPE
    _note(first, last, start, current, low, high, count)
    for stripe in range(start.shape[0] - 1):
        start[stripe + 1] += start[stripe]
        order.fill[stripe] = start[stripe]
    for p in range(positions.shape[0]):
        stripe = order.stripes[p]
        order.particles[order.fill[stripe]] = p
        order.fill[stripe] += 1
    for row in range(rows - 1, -1, -1):
        for below in range(max(row - 2, 0), row):
            first[row] = min(first[row], first[below])
            last[row] = max(last[row], last[below])
        if last[row] >= 0:
            last[row] += 2
        for column in range(first[row], last[row] + 1):
            for k in range(5):
                grid.sums[row, column, k] = 0.0
    return -1


@inside_kernel
def _note(first, last, start, row, low, high, count):
    """Enter a run of particles of one row of cells."""
    first[row] = min(first[row], low)
    last[row] = max(last[row], high)
    start[row // STRIPE + 1] += count

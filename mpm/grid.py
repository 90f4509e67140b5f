"""The background grid: blocks of 4 x 4 (x 4) nodes, of which only those near particles have storage.

Node (i, j, k) lies at base + (i + 1/2, j + 1/2, k + 1/2) h: half a cell off the planes at whole numbers of cells from
`base`, which symmetry planes, axis and wall are. In two dimensions there is one layer, k = 0.

A flat record of eight numbers per node holds velocity before the forces (momentum, while it is being summed), mass,
force and one spare; a second one of four the velocity after the forces. Lanes read them in one or two pieces.
"""

import math
from typing import NamedTuple

import numpy as np

from core_models.compilation import inside_kernel, kernel
from core_models.dispatch import generic
from core_models.errors import SceneError
from core_models.geometry import Axisymmetric, Geometry, PlaneStrain, Spatial

EDGE = 4  # nodes along the edge of a block; the code counts them in two bits
RECORD, MASS, FORCE = 8, 3, 4
VELOCITY = 4  # numbers in a record of the velocity after the forces
MOST_BLOCKS = 50_000_000  # in the box round the body, 4 bytes each
MARGIN = 0.25  # part of the body's size that the box leaves free on each side
NEXT = 2  # blocks along an axis that the particles of one block reach


class Grid(NamedTuple):
    """Arrays of the grid.

    h, over_h : cell size [m] and its inverse. base : (3,) [m]. low : (3,) block that the box begins with, counted from
    base. shape : (3,) blocks of the box. table : (blocks of the box,) number of each in storage, or -1; x runs fastest.
    homes : places in the table of the blocks that hold particles, colour by colour. stored : places of the blocks
    with storage, by number. nodes, after : flat records.
    """

    h: float
    over_h: float
    base: np.ndarray
    low: np.ndarray
    shape: np.ndarray
    table: np.ndarray
    homes: np.ndarray
    stored: np.ndarray
    nodes: np.ndarray
    after: np.ndarray


@generic
def block_nodes(geometry):
    """Nodes of a block: a constant when compiled."""


@block_nodes.register(Axisymmetric)
@block_nodes.register(PlaneStrain)
def _(geometry):
    return EDGE * EDGE


@block_nodes.register(Spatial)
def _(geometry):
    return EDGE * EDGE * EDGE


def find_box(cell_size: float, base: np.ndarray, positions: np.ndarray) -> np.ndarray:
    """The first block and the number of blocks (2, 3) with room for particles at these positions (n, d) [m].

    Raises SceneError for a box of blocks that no memory would hold.
    """
    dimension = positions.shape[1]
    size = EDGE * cell_size
    low, high = positions.min(axis=0) - base[:dimension], positions.max(axis=0) - base[:dimension]
    room = MARGIN * (high - low)
    first, last = np.zeros(3), np.zeros(3)
    first[:dimension] = np.floor((low - room) / size) - 1
    last[:dimension] = np.floor((high + room) / size) + NEXT
    shape = last - first + 1
    if not shape.prod() <= MOST_BLOCKS:
        raise SceneError(
            f"a grid of {' x '.join(f'{EDGE * n:.3g}' for n in shape[:dimension])} nodes for cells of "
            f"{cell_size:.3g} m is too large: give larger cells (at most {EDGE**dimension * MOST_BLOCKS:.0e} nodes)"
        )
    return np.array([first, shape], dtype=np.int64)


def make_grid(cell_size: float, base: np.ndarray, box: np.ndarray, particles: int) -> Grid:
    """Grid of a box (2, 3) of blocks, as `find_box` returns it, for so many particles, without storage yet."""
    low, shape = box
    count = int(shape.prod())
    return Grid(
        cell_size,
        1.0 / cell_size,
        base,
        low,
        shape,
        np.full(count, -1, dtype=np.int32),
        np.zeros(min(particles, count), dtype=np.int32),
        np.zeros(min(NEXT**3 * particles, count), dtype=np.int32),
        np.zeros(0),
        np.zeros(0),
    )


def with_storage(geometry: Geometry, grid: Grid, blocks: int) -> Grid:
    """The grid with storage for that many blocks; the same one where it has that already."""
    nodes = block_nodes(geometry) * blocks
    if len(grid.after) >= VELOCITY * nodes:
        return grid
    nodes = math.ceil(1.2 * nodes)
    return grid._replace(nodes=np.zeros(RECORD * nodes), after=np.zeros(VELOCITY * nodes))


@inside_kernel
def block_corner(grid, place):
    """First node of the block at a place of the table."""
    row, i = divmod(place, grid.shape[0])
    k, j = divmod(row, grid.shape[1])
    return EDGE * (i + grid.low[0]), EDGE * (j + grid.low[1]), EDGE * (k + grid.low[2])


@inside_kernel
def node_in(geometry, grid, place, i, j, k):
    """Number of the node (i, j, k), counted from the first of the block at a place of the table; its block exists."""
    shape = grid.shape
    block = grid.table[place + (i >> 2) + shape[0] * ((j >> 2) + shape[1] * (k >> 2))]
    return block * block_nodes(geometry) + (((k & 3) << 4) | ((j & 3) << 2) | (i & 3))


@inside_kernel
def node_at(geometry, grid, i, j, k):
    """Number of the node (i, j, k), counted from base, or -1 where it has no storage."""
    i, j = i - EDGE * grid.low[0], j - EDGE * grid.low[1]
    k = k - EDGE * grid.low[2]
    x, y, z = i >> 2, j >> 2, k >> 2
    shape = grid.shape
    if x < 0 or y < 0 or z < 0 or x >= shape[0] or y >= shape[1] or z >= shape[2]:
        return -1
    block = grid.table[x + shape[0] * (y + shape[1] * z)]
    if block < 0:
        return -1
    return block * block_nodes(geometry) + (((k & 3) << 4) | ((j & 3) << 2) | (i & 3))


@kernel
def clear(first, last, array, size):
    """Set the pieces first ... last-1 of `size` numbers each to 0."""
    for place in range(first * size, last * size):
        array[place] = 0.0

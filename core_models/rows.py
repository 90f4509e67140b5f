"""The workspace of a thread: every number of a point in a row of its own, over a block of points.

The arrays of a `State` hold the components of a tensor side by side; here those of neighbouring points are, and all
distances are constants. The compiler then takes several points per instruction wherever a loop runs over k without
calls or loops inside.
"""

from typing import NamedTuple

import numpy as np

from core_models.compilation import inside_kernel

# First row of each quantity. The loops read F and the state before, and leave the state after in the same rows, but
# for the rotation.
F0, F1 = 0, 9
STRESS, ROTATION_0, ROTATION_1, ELASTIC = 18, 24, 27, 30
PLASTIC_STRAIN, HARDENING, TEMPERATURE, DAMAGE, ENERGY = 36, 37, 38, 39, 40
PREDICTION, GUESS, CORRECTION, BALANCE, LENGTH = 41, 54, 55, 59, 64
PLASTIC_VOLUME, POROSITY, BACK_STRESS = 65, 66, 67
LARGEST_NUMBER_OF_BACK_STRESSES = 4
ROWS = BACK_STRESS + 6 * LARGEST_NUMBER_OF_BACK_STRESSES
BLOCK = 32  # points that are advanced together: their rows stay in the nearest cache
STRIDE = BLOCK + 8  # a cache line more, lest all rows fall in the same few places of the cache


class Workspace(NamedTuple):
    """What a thread works in: the rows and the status of each point."""

    rows: np.ndarray
    statuses: np.ndarray


def make_workspace() -> Workspace:
    """A workspace for one thread."""
    return Workspace(np.zeros(ROWS * STRIDE), np.zeros(BLOCK, dtype=np.int64))


@inside_kernel
def get(rows, row, k):
    """Number of point k in a row."""
    # Unsigned: an index that might count from the end would keep the compiler from taking points together.
    return rows[np.uint64(row * STRIDE + k)]


@inside_kernel
def put(rows, row, k, value):
    """Write the number of point k in a row."""
    rows[np.uint64(row * STRIDE + k)] = value


@inside_kernel
def get_vector(rows, row, k):
    """Vector of point k in three rows."""
    return (get(rows, row, k), get(rows, row + 1, k), get(rows, row + 2, k))


@inside_kernel
def put_vector(rows, row, k, v):
    """Write the vector of point k in three rows."""
    put(rows, row, k, v[0])
    put(rows, row + 1, k, v[1])
    put(rows, row + 2, k, v[2])


@inside_kernel
def get_symmetric(rows, row, k):
    """Symmetric tensor of point k in six rows."""
    return (
        get(rows, row, k), get(rows, row + 1, k), get(rows, row + 2, k),
        get(rows, row + 3, k), get(rows, row + 4, k), get(rows, row + 5, k),
    )  # fmt: skip


@inside_kernel
def put_symmetric(rows, row, k, s):
    """Write the symmetric tensor of point k in six rows."""
    put(rows, row, k, s[0])
    put(rows, row + 1, k, s[1])
    put(rows, row + 2, k, s[2])
    put(rows, row + 3, k, s[3])
    put(rows, row + 4, k, s[4])
    put(rows, row + 5, k, s[5])


@inside_kernel
def get_tensor(rows, row, k):
    """Tensor of point k in nine rows."""
    return (
        get(rows, row, k), get(rows, row + 1, k), get(rows, row + 2, k),
        get(rows, row + 3, k), get(rows, row + 4, k), get(rows, row + 5, k),
        get(rows, row + 6, k), get(rows, row + 7, k), get(rows, row + 8, k),
    )  # fmt: skip

"""The sparse stiffness between free degrees of freedom: its pattern is made once, its numbers are gathered."""

from collections.abc import Sequence

import numpy as np

from core_models.compilation import kernel
from core_models.threads import Threads

SLOT_CHUNK = 4096  # entries of the matrix; fixed, so that sums do not depend on the number of threads


def dofs_of(nodes: np.ndarray, dimension: int) -> np.ndarray:
    """Degrees of freedom (m, a d) of cells with nodes (m, a): d node + component."""
    return (dimension * nodes[:, :, None] + np.arange(dimension)).reshape(len(nodes), -1)


class Pattern:
    """Compressed rows of a matrix that small square blocks add up to.

    tables : arrays (m, k) of degrees of freedom, one row for each block of k x k numbers. free : (dofs,) bool; rows and
    columns of the others are left out.

    size : of the matrix. row_starts (size + 1,), columns : compressed rows, columns ascending. Every entry
    lists the numbers of blocks that it is the sum of, always in the same order.
    """

    def __init__(self, tables: Sequence[np.ndarray], free: np.ndarray, threads: Threads) -> None:
        self._threads = threads
        number = np.where(free, np.cumsum(free) - 1, -1)
        self.size = int(free.sum())
        rows = np.concatenate([np.repeat(number[t], t.shape[1], axis=1).ravel() for t in tables])
        columns = np.concatenate([np.tile(number[t], (1, t.shape[1])).ravel() for t in tables])
        kept = np.flatnonzero((rows >= 0) & (columns >= 0))
        keys = rows[kept] * self.size + columns[kept]
        order = np.argsort(keys, kind="stable")
        self._entries = kept[order]
        keys = keys[order]
        first = np.flatnonzero(np.concatenate([[True], keys[1:] != keys[:-1]])) if keys.size else keys
        self._starts = np.append(first, keys.size)
        self.columns = (keys[first] % max(self.size, 1)).astype(np.int32)
        per_row = np.bincount(keys[first] // max(self.size, 1), minlength=self.size)
        self.row_starts = np.concatenate([[0], np.cumsum(per_row)]).astype(np.int32)
        self._values = np.zeros(len(self.columns))

    def assemble(self, blocks: Sequence[np.ndarray]) -> np.ndarray:
        """Numbers (entries,) of the matrix for blocks (m, k, k), one array for each table; overwritten next time."""
        flat = [block.reshape(-1) for block in blocks]
        numbers = flat[0] if len(flat) == 1 else np.concatenate(flat)
        chunks = -(-len(self._values) // SLOT_CHUNK)
        self._threads.run(gather_blocks, chunks, self._starts, self._entries, numbers, self._values)
        return self._values


@kernel
def gather_blocks(first, last, starts, entries, numbers, values):
    """values[i] = sum of numbers[entries[k]], k = starts[i] ... starts[i + 1] - 1, for chunks of SLOT_CHUNK entries."""
    for i in range(first * SLOT_CHUNK, min(last * SLOT_CHUNK, values.shape[0])):
        total = 0.0
        for k in range(starts[i], starts[i + 1]):
            total += numbers[entries[k]]
        values[i] = total

"""Run a range kernel on several threads, with the same machine code and the same sums for any number of them."""

import os
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor

from core_models.errors import SceneError

LEAST_WORK = 6e-4  # s of a kernel's call, below which handing parts of it over takes longer than they do


class Threads:
    """A team of threads that share the chunks of a kernel `kernel(first, last, *arguments)`.

    Parameters
    ----------
    count : number of threads, 1 up to what the machine has.

    Kernels release the interpreter lock and write to rows of their own chunks only, so the result does not depend on
    `count`, nor on which calls are shared: those that take LEAST_WORK or more, as far as calls before have shown.
    """

    def __init__(self, count: int = 1) -> None:
        available = os.cpu_count() or 1
        if not isinstance(count, int) or not 1 <= count <= available:
            raise SceneError(
                f"--threads {count}: this machine has {available}; give a number from 1 to {available}"
            )
        self.count = count
        self._pool = ThreadPoolExecutor(count - 1, thread_name_prefix="matpoint") if count > 1 else None
        self._called: set[Callable] = set()
        self._seconds: dict[Callable, float] = {}

    def run(self, kernel, chunks: int, *arguments) -> None:
        """Call kernel(first, last, *arguments) for chunks 0 ... chunks-1, split evenly over the threads.

        Raises what a worker raised.
        """
        self._share(kernel, chunks, lambda _thread, first, last: kernel(first, last, *arguments))

    def run_with(self, kernel, chunks: int, own: list, *arguments) -> None:
        """The same for a kernel(first, last, own[thread], *arguments) that needs something of its thread's own."""
        self._share(kernel, chunks, lambda thread, first, last: kernel(first, last, own[thread], *arguments))

    def _share(self, kernel: Callable, chunks: int, call: Callable[[int, int, int], None]) -> None:
        if self._pool is None:
            call(0, 0, chunks)
            return
        shares = self.count if self._is_worth_it(kernel, chunks) else 1
        cuts = [chunks * k // shares for k in range(shares + 1)]
        others = [self._pool.submit(call, k, cuts[k], cuts[k + 1]) for k in range(1, shares)]
        began = time.perf_counter()
        call(0, 0, cuts[1])
        self._note(kernel, cuts[1], time.perf_counter() - began)
        for other in others:
            other.result()

    def _is_worth_it(self, kernel: Callable, chunks: int) -> bool:
        return chunks >= 2 * self.count and self._seconds.get(kernel, 0.0) * chunks >= LEAST_WORK

    def _note(self, kernel: Callable, chunks: int, seconds: float) -> None:
        """Keep the least time of a chunk; the first call, which may have compiled the kernel, tells nothing."""
        if kernel in self._called and chunks:
            self._seconds[kernel] = min(self._seconds.get(kernel, seconds / chunks), seconds / chunks)
        self._called.add(kernel)

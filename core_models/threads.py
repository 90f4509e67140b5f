"""Run a range kernel on several threads, with the same machine code and the same sums for any number of them."""

import os
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor

from core_models.errors import SceneError


class Threads:
    """A team of threads that share the chunks of a kernel `kernel(first, last, *arguments)`.

    Parameters
    ----------
    count : number of threads, 1 up to what the machine has.

    Kernels release the interpreter lock and write to rows of their own chunks only, so the result does not depend on
    `count`; with one thread the kernel is called directly.
    """

    def __init__(self, count: int = 1) -> None:
        available = os.cpu_count() or 1
        if not isinstance(count, int) or not 1 <= count <= available:
            raise SceneError(
                f"--threads {count}: this machine has {available}; give a number from 1 to {available}"
            )
        self.count = count
        self._pool = ThreadPoolExecutor(count - 1, thread_name_prefix="matpoint") if count > 1 else None

    def run(self, kernel, chunks: int, *arguments) -> None:
        """Call kernel(first, last, *arguments) for chunks 0 ... chunks-1, split evenly over the threads.

        Raises what a worker raised.
        """
        self._share(chunks, lambda _thread, first, last: kernel(first, last, *arguments))

    def run_with(self, kernel, chunks: int, own: list, *arguments) -> None:
        """The same for a kernel(first, last, own[thread], *arguments) that needs something of its thread's own."""
        self._share(chunks, lambda thread, first, last: kernel(first, last, own[thread], *arguments))

    def _share(self, chunks: int, call: Callable[[int, int, int], None]) -> None:
        if self._pool is None or chunks < 2 * self.count:
            call(0, 0, chunks)
            return
        cuts = [chunks * k // self.count for k in range(self.count + 1)]
        others = [self._pool.submit(call, k, cuts[k], cuts[k + 1]) for k in range(1, self.count)]
        call(0, 0, cuts[1])
        for other in others:
            other.result()

"""What a step takes where every thread has a processor to itself, measured on processors that others use too."""

import time
from collections.abc import Callable

from core_models.threads import Threads


class ThreadClock:
    """Clock of a team of threads: the calling thread's processor time, and what other threads computed longer.

    `read()` is the length of the critical path so far [s]. It leaves out waiting for a processor, and what threads
    lose to each other by sharing memory's bandwidth unless they ran side by side.
    """

    def __init__(self, threads: Threads) -> None:
        self._beyond = 0.0
        self._count, self._share = threads.count, threads._share
        threads._share = self._clocked

    def read(self) -> float:
        """Seconds of the critical path."""
        return time.thread_time() + self._beyond

    def _clocked(self, kernel: Callable, chunks: int, call: Callable[[int, int, int], None]) -> None:
        spent = [0.0] * self._count

        def timed(thread: int, first: int, last: int) -> None:
            began = time.thread_time()
            call(thread, first, last)
            spent[thread] = time.thread_time() - began

        self._share(kernel, chunks, timed)
        self._beyond += max(spent) - spent[0]

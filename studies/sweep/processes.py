"""Jobs in processes of this machine, without Dask: a process that dies costs its own job only."""

import multiprocessing
import signal
from collections import deque
from collections.abc import Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, Future, ProcessPoolExecutor, wait
from contextlib import contextmanager
from typing import Any

from studies.sweep.job import Job, failed, perform


def results_by_processes(jobs: Sequence[Job], workers: int) -> Iterator[dict[str, Any]]:
    """Results in the order in which they come; a job whose process died is tried once more, alone."""
    left, lost = deque(jobs), []
    while left:
        for job, result in _in_pool(left, workers):
            if result is None:
                lost.append(job)
            else:
                yield result
    for job in lost:
        ((_, result),) = _in_pool(deque([job]), 1)
        yield result or failed(
            job.key, "its process died twice: perhaps for want of memory; try a coarser resolution"
        )


def _in_pool(left: deque[Job], workers: int) -> Iterator[tuple[Job, dict[str, Any] | None]]:
    """Do jobs that are left, as many at a time as there are workers, until none is or a process dies.

    A process that dies takes the pool, and all that it was working on, with it: those jobs have no result.
    """
    context = multiprocessing.get_context("spawn")
    with (
        ProcessPoolExecutor(workers, mp_context=context, initializer=_leave_ctrl_c) as pool,
        _ending_with_us(),
    ):
        working: dict[Future, Job] = {}
        broken = False
        while working or (left and not broken):
            while left and not broken and len(working) < workers:
                job = left.popleft()
                try:
                    working[pool.submit(perform, job)] = job
                except BrokenExecutor:
                    left.appendleft(job)
                    broken = True
            for future in wait(working, return_when=FIRST_COMPLETED).done:
                job = working.pop(future)
                try:
                    yield job, future.result()
                except BrokenExecutor:
                    broken = True
                    yield job, None


def _leave_ctrl_c() -> None:
    """Ctrl-C reaches all processes of a terminal: the one that has the others ends them."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)


@contextmanager
def _ending_with_us() -> Iterator[None]:
    """End the processes that were started inside when it is left by an interruption, in place of waiting for them."""
    before = set(multiprocessing.active_children())
    try:
        yield
    except BaseException:
        for process in set(multiprocessing.active_children()) - before:
            process.terminate()
        raise

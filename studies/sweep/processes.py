"""Jobs in processes of this machine, without Dask: a process that dies costs its own job only."""

import multiprocessing
from collections.abc import Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, Future, ProcessPoolExecutor, wait
from typing import Any

from studies.sweep.job import Job, failed, perform

TRIES = 2  # of a job whose process died, alone the last time


def results_by_processes(jobs: Sequence[Job], workers: int) -> Iterator[dict[str, Any]]:
    """Results in the order in which they come."""
    left = list(jobs)
    for width in [workers] + [1] * (TRIES - 1):
        # A process that dies takes the pool, and all that it was working on, with it: those jobs are tried again.
        lost: list[Job] = []
        for group in [left] if width > 1 else [[job] for job in left]:
            for job, result in _in_pool(group, width):
                if result is None:
                    lost.append(job)
                else:
                    yield result
        left = lost
        if not left:
            return
    for job in left:
        yield failed(job.key, "its process died twice: perhaps for want of memory; try a coarser resolution")


def _in_pool(jobs: Sequence[Job], workers: int) -> Iterator[tuple[Job, dict[str, Any] | None]]:
    context = multiprocessing.get_context("spawn")
    with ProcessPoolExecutor(workers, mp_context=context) as pool:
        waiting: dict[Future, Job] = {pool.submit(perform, job): job for job in jobs}
        while waiting:
            for future in wait(waiting, return_when=FIRST_COMPLETED).done:
                job = waiting.pop(future)
                try:
                    yield job, future.result()
                except BrokenExecutor:
                    yield job, None

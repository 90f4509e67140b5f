"""A sweep: jobs that are not done yet are done, and each result is kept as soon as it comes."""

import os
from collections.abc import Callable, Iterator, Sequence
from typing import Any

from core_models.errors import UnsupportedError
from studies.output.output_folder import OutputFolder
from studies.output.study_folder import keep, kept
from studies.sweep.dask_cluster import client_of, is_installed, results_by_dask
from studies.sweep.job import COMPLETE, Job
from studies.sweep.processes import results_by_processes

Result = dict[str, Any]


def run_sweep(
    jobs: Sequence[Job],
    folder: OutputFolder,
    *,
    scheduler: str | None = None,
    workers: int | None = None,
    tell: Callable[[Result, int, int], None] = lambda result, done, all_: None,
) -> list[Result]:
    """Results of all jobs, in their order; those that the folder holds from an earlier time are not done again.

    scheduler : address of a running Dask scheduler; None for a Dask cluster of this machine, or, without Dask, plain
    processes. workers : processes on this machine, by default one for each processor.
    tell : called with each result, how many there are by now, and how many there will be.
    A job that had failed before is tried again. Raises what `check_scheduler` does.
    """
    check_scheduler(scheduler)
    known = {job.key: _kept(folder, job.key) for job in jobs}
    left = [job for job in jobs if known[job.key] is None]
    done = len(jobs) - len(left)
    for result in _results(left, scheduler, workers or len(os.sched_getaffinity(0))) if left else ():
        known[result["key"]] = result
        keep(folder, result["key"], result)
        done += 1
        tell(result, done, len(jobs))
    return [known[job.key] for job in jobs]


def check_scheduler(scheduler: str | None) -> None:
    """Refuse a scheduler that cannot be used, before anything is written.

    Raises UnsupportedError for any without Dask, SceneError for one that does not answer.
    """
    if scheduler is None:
        return
    if not is_installed():
        raise UnsupportedError(
            "--scheduler needs Dask: pip install 'matpoint[sweep]'; or leave it out, for processes of this machine"
        )
    with client_of(scheduler, 0):
        pass


def _kept(folder: OutputFolder, key: str) -> Result | None:
    result = kept(folder, key)
    return result if result and result["status"] == COMPLETE else None


def _results(jobs: Sequence[Job], scheduler: str | None, workers: int) -> Iterator[Result]:
    if is_installed():
        with client_of(scheduler, workers) as client:
            yield from results_by_dask(jobs, client)
    else:
        yield from results_by_processes(jobs, workers)

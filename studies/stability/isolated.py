"""Cells in processes of their own, with limits of time and memory: what hangs or crashes is a failure, not the end."""

import logging
import multiprocessing
import resource
import signal
import time
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from multiprocessing.connection import Connection, wait
from multiprocessing.context import ForkProcess
from typing import Any, NamedTuple

import fem  # noqa: F401 - imported once, before processes are made
import mpm  # noqa: F401
from studies.stability.cases import find_case
from studies.stability.cell import FAILED, Cell, as_json, run_cell

TIME_LIMIT = 300.0  # s of processor time
PATIENCE = 10.0  # times as long by the clock, for machines that are busy and processes that sleep
MEMORY_LIMIT = 6 * 2**30  # bytes
Result = dict[str, Any]


class Task(NamedTuple):
    """Work for a process of its own: the cell that fails if it does, and what gives its result."""

    case: str
    variant: str
    work: Callable[[], Result]


class _Running(NamedTuple):
    task: Task
    process: ForkProcess
    pipe: Connection
    until: float


def run_isolated(cells: Sequence[tuple[str, str]], quick: bool, workers: int) -> Iterator[Result]:
    """Results of `studies.stability.cell` for cases and variants as plain data, in the order in which they come."""
    tasks = [
        Task(
            case,
            variant,
            lambda case=case, variant=variant: as_json(run_cell(find_case(case), variant, quick)),
        )
        for case, variant in cells
    ]
    return results_of(tasks, TIME_LIMIT, workers)


def results_of(tasks: Sequence[Task], within: float, workers: int) -> Iterator[Result]:
    """Do tasks in forked processes, which have all imports already, so many at a time; results as they come.

    A process that dies, or takes more than `within` [s] of processor time, has failed its cell.
    """
    left, running = deque(tasks), {}
    try:
        while left or running:
            while left and len(running) < workers:
                started = _start(left.popleft(), within)
                running[started.pipe] = started
            patience = min(started.until for started in running.values()) - time.monotonic()
            ready = wait(list(running), max(patience, 0.0))
            now = time.monotonic()
            for pipe in [pipe for pipe in running if pipe in ready or running[pipe].until <= now]:
                result = _result(running[pipe], within)
                _end(running.pop(pipe))
                yield result
    finally:
        for started in running.values():
            _end(started)


def _start(task: Task, within: float) -> _Running:
    context = multiprocessing.get_context("fork")
    mine, its = context.Pipe(duplex=False)
    process = context.Process(target=_limited, args=(task.work, its, within))
    process.start()
    its.close()
    return _Running(task, process, mine, time.monotonic() + PATIENCE * within)


def _result(started: _Running, within: float) -> Result:
    """What a process has sent, or why it has sent nothing."""
    try:
        return started.pipe.recv() if started.pipe.poll() else _failed(started.task, _too_long(within))
    except EOFError:
        started.process.join()
        return _failed(started.task, _ending(started.process.exitcode, within))


def _end(started: _Running) -> None:
    started.process.kill()
    started.process.join()
    started.pipe.close()


def _limited(work: Callable[[], Result], pipe: Connection, within: float) -> None:
    spent = sum(resource.getrusage(resource.RUSAGE_SELF)[:2])
    seconds = int(spent + max(within, 1.0))
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 1))
    resource.setrlimit(resource.RLIMIT_DATA, (MEMORY_LIMIT, MEMORY_LIMIT))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    # A command that is told to end ends its processes itself: they need not say anything.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    logging.getLogger().handlers[:] = [
        logging.NullHandler()
    ]  # hard cases are warned of, each time: it is known
    pipe.send(work())


def _ending(status: int, within: float) -> str:
    if status == -signal.SIGXCPU:
        return _too_long(within)
    return f"crashed with signal {-status}" if status < 0 else f"ended with status {status} and no result"


def _too_long(within: float) -> str:
    return f"not at its end after {within:g} s"


def _failed(task: Task, why: str) -> Result:
    return as_json(Cell(task.case, task.variant, FAILED, why))

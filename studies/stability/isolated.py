"""A cell in a process of its own, with limits of time and memory: what hangs or crashes is a failure, not the end."""

import logging
import multiprocessing
import resource
import signal
from collections.abc import Callable
from multiprocessing.connection import Connection
from typing import Any

import fem  # noqa: F401 - imported once, before processes are made
import mpm  # noqa: F401
from studies.stability.cases import find_case
from studies.stability.cell import FAILED, Cell, as_json, run_cell

TIME_LIMIT = 300.0  # s of processor time
PATIENCE = 10.0  # times as long by the clock, for machines that are busy and processes that sleep
MEMORY_LIMIT = 6 * 2**30  # bytes
Result = dict[str, Any]


def run_isolated(case: str, variant: str, quick: bool, within: float = TIME_LIMIT) -> Result:
    """The result of `studies.stability.cell` as plain data; a process that dies or takes too long has failed."""
    return judged(case, variant, lambda: as_json(run_cell(find_case(case), variant, quick)), within)


def judged(case: str, variant: str, work: Callable[[], Result], within: float) -> Result:
    """Do the work in a forked process, which has all imports already; what else it does is why the cell has failed."""
    context = multiprocessing.get_context("fork")
    mine, its = context.Pipe(duplex=False)
    process = context.Process(target=_limited, args=(work, its, within))
    process.start()
    its.close()
    try:
        return mine.recv() if mine.poll(PATIENCE * within) else _failed(case, variant, _too_long(within))
    except EOFError:
        process.join()
        return _failed(case, variant, _ending(process.exitcode, within))
    finally:
        process.kill()
        process.join()
        mine.close()


def _limited(work: Callable[[], Result], pipe: Connection, within: float) -> None:
    spent = sum(resource.getrusage(resource.RUSAGE_SELF)[:2])
    seconds = int(spent + max(within, 1.0))
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 1))
    resource.setrlimit(resource.RLIMIT_DATA, (MEMORY_LIMIT, MEMORY_LIMIT))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
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


def _failed(case: str, variant: str, why: str) -> Result:
    return as_json(Cell(case, variant, FAILED, why))

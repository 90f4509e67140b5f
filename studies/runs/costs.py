"""What a run costs: time, processor time, compilation, memory."""

import resource
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from numba.core.event import Listener, install_listener

from studies.process import check_interrupted


@dataclass
class Cost:
    """wall_s: all of the run's time (mesh, compilation, steps, output); of it setup_s, stepping_s, output_s.

    cpu_s: processor time of all threads. compile_s: true compilation, loads from the cache not counted; it is
    part of wall_s. point_updates: calls of the material law. peak_memory_bytes: of the whole process during
    the run.
    """

    wall_s: float = 0.0
    cpu_s: float = 0.0
    compile_s: float = 0.0
    setup_s: float = 0.0
    stepping_s: float = 0.0
    output_s: float = 0.0
    steps: int = 0
    point_updates: int = 0
    peak_memory_bytes: int = 0

    def add(self, wall_s: float, cpu_s: float) -> None:
        """Count what earlier processes of a resumed run had spent, as stepping [s]."""
        self.wall_s += wall_s
        self.cpu_s += cpu_s
        self.stepping_s += wall_s


class _CompileClock(Listener):
    """Time between the outermost start and end of compilation: a function compiles the ones it calls."""

    def __init__(self) -> None:
        self.total = 0.0
        self._depth = 0

    def on_start(self, event) -> None:
        if self._depth == 0:
            self._began = time.perf_counter()
        self._depth += 1

    def on_end(self, event) -> None:
        self._depth -= 1
        if self._depth == 0:
            self.total += time.perf_counter() - self._began


@contextmanager
def measured() -> Iterator[Cost]:
    """Measure what happens inside: wall, processor and compile time, peak memory.

    An interruption that was swallowed before, as while compiling, ends the command here.
    """
    check_interrupted()
    cost, compiling = Cost(), _CompileClock()
    _reset_peak_memory()
    wall, cpu = time.perf_counter(), time.process_time()
    with install_listener("numba:compile", compiling):
        try:
            yield cost
        finally:
            cost.wall_s = time.perf_counter() - wall
            cost.cpu_s = time.process_time() - cpu
            cost.compile_s = compiling.total
            cost.peak_memory_bytes = _peak_memory()


def _reset_peak_memory() -> None:
    # Linux keeps the high-water mark per process and lets it be reset, so that one run does not
    # report its predecessor's; elsewhere the mark is that of the process so far.
    try:
        Path("/proc/self/clear_refs").write_text("5")
    except OSError:
        return


def _peak_memory() -> int:
    try:
        status = Path("/proc/self/status").read_text()
    except OSError:
        peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        return peak if sys.platform == "darwin" else peak * 1024
    return next(int(line.split()[1]) * 1024 for line in status.splitlines() if line.startswith("VmHWM"))

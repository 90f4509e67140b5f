"""Observer: ends a run that takes too long."""

import time

from core_models.errors import RunFailure
from studies.observers.observer import Observer


class Deadline(Observer):
    """Raises RunFailure when a run has not ended some seconds of processor time after its first step."""

    def __init__(self, seconds: float) -> None:
        self._seconds = seconds
        self._began: float | None = None

    def step(self, solver) -> None:
        """Look at the processor time of this thread: what else the machine does, does not count."""
        if self._began is None:
            self._began = time.thread_time()
        elif time.thread_time() - self._began > self._seconds:
            raise RunFailure(
                f"step {solver.step_count}, t = {solver.time:.6e} s: not at its end after {self._seconds:g} s, with "
                f"steps of {solver.time_step:.2e} s; give more time or a coarser resolution"
            )

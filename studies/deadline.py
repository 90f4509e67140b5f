"""Observer: ends a run that takes too long."""

import time

from core_models.errors import RunFailure
from studies.observer import Observer


class Deadline(Observer):
    """Raises RunFailure when a run has not ended some seconds after its first step; its compilation does not count."""

    def __init__(self, seconds: float) -> None:
        self._seconds = seconds
        self._began: float | None = None

    def step(self, solver) -> None:
        """Look at the clock."""
        if self._began is None:
            self._began = time.monotonic()
        elif time.monotonic() - self._began > self._seconds:
            raise RunFailure(
                f"step {solver.step_count}, t = {solver.time:.6e} s: not at its end after {self._seconds:g} s, with "
                f"steps of {solver.time_step:.2e} s; give more time or a coarser resolution"
            )

"""Observer: when the bar first and last touched the wall."""

import math

import numpy as np

from core_models.checkpoint import Checkpoint
from studies.observers.observer import Observer


class ContactWatch(Observer):
    """first, last [s]: beginning of the first step and end of the last step in contact; None before any."""

    def __init__(self) -> None:
        self.first: float | None = None
        self.last: float | None = None

    def start(self, solver) -> None:
        """Begin before the first step."""
        self._previous_time = solver.time

    def resume(self, solver, checkpoint: Checkpoint) -> None:
        """Go on with what had been seen."""
        known = [None if math.isnan(time) else float(time) for time in checkpoint["times"]]
        self.first, self.last, self._previous_time = known

    def checkpoint(self) -> Checkpoint:
        """First, last and previous time [s]; NaN for none."""
        times = (self.first, self.last, self._previous_time)
        return {"times": np.array([math.nan if time is None else time for time in times])}

    def step(self, solver) -> None:
        """Look once after each step."""
        if solver.in_contact:
            self.last = solver.time
            if self.first is None:
                self.first = self._previous_time
        self._previous_time = solver.time

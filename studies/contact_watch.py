"""Observer: when the bar first and last touched the wall."""

from studies.observer import Observer


class ContactWatch(Observer):
    """first, last [s]: beginning of the first step and end of the last step in contact; None before any."""

    def __init__(self) -> None:
        self.first: float | None = None
        self.last: float | None = None

    def start(self, solver) -> None:
        """Begin before the first step."""
        self._previous_time = solver.time

    def step(self, solver) -> None:
        """Look once after each step."""
        if solver.in_contact:
            self.last = solver.time
            if self.first is None:
                self.first = self._previous_time
        self._previous_time = solver.time

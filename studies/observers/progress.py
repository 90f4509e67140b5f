"""Observer: a progress bar with the time left of a run and of all, when the output is a terminal."""

import os
import sys
import time
from typing import TextIO

from studies.observers.observer import Observer
from studies.output.clock import clock
from studies.runs.ending import Ending
from studies.runs.remaining import Remaining

WIDTH = 20
REFRESH = 0.2  # s


class Progress(Observer):
    """One line on stderr, rewritten a few times a second and wiped at the end; of several runs, with what all take."""

    def __init__(
        self, label: str, ending: Ending, remaining: Remaining, stream: TextIO | None = None
    ) -> None:
        self._label = label if remaining.is_one else f"{remaining.place} {label}"
        self._ending, self._remaining = ending, remaining
        self._stream = stream or sys.stderr
        self._shown = 0.0

    def start(self, solver) -> None:
        """Start the clock and show that compilation may be under way."""
        self._remaining.begin()
        self._show(f"{self._label}  starting; the first run of a kind compiles for some seconds ...")

    def resume(self, solver, checkpoint) -> None:
        """Start the clock anew."""
        self.start(solver)

    def step(self, solver) -> None:
        """Redraw when the last drawing is old enough."""
        now = time.monotonic()
        if now - self._shown < REFRESH:
            return
        self._shown = now
        share = min(solver.time / self._ending.expected(solver), 1.0)
        own, whole = self._remaining.left(share)
        said = f"{solver.time * 1e6:7.2f} µs  {clock(own)} left"
        if not self._remaining.is_one:
            said = f"{clock(own)} left, all {clock(whole)}"
        self._show(f"{self._label}  [{'#' * int(WIDTH * share):<{WIDTH}}] {share:4.0%}  {said}")

    def finish(self, solver) -> None:
        """Wipe the line."""
        self.abandon()

    def abandon(self) -> None:
        """Wipe the line."""
        self._show("")

    def _show(self, text: str) -> None:
        self._stream.write(f"\r\x1b[K{text[: columns(self._stream) - 1]}")
        self._stream.flush()


def can_show(stream: TextIO) -> bool:
    """Whether a stream is a terminal that can rewrite its line."""
    return stream.isatty() and os.environ.get("TERM") != "dumb"


def columns(stream: TextIO) -> int:
    """Width of the terminal; 80 where it cannot be known."""
    try:
        return os.get_terminal_size(stream.fileno()).columns or 80
    except OSError:
        return 80

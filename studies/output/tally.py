"""Progress of a study of many runs: how many are done, of how many, and about how long the rest takes."""

import sys
import time
from typing import TextIO

from studies.output.clock import clock

LONGEST = 120  # letters of what is said of a run


class Tally:
    """One line on stderr for each run that is done; the time left is that of the runs so far, on average."""

    def __init__(self, total: int, stream: TextIO | None = None) -> None:
        self._total, self._stream = total, stream or sys.stderr
        self._done = 0
        self._began = time.monotonic()

    def tell(self, text: str) -> None:
        """Count one more run and say what became of it."""
        self._done += 1
        left = (time.monotonic() - self._began) / self._done * max(self._total - self._done, 0)
        said = text if len(text) <= LONGEST else f"{text[: LONGEST - 1]}…"
        print(f"[{self._done}/{self._total}, {clock(left)} left] {said}", file=self._stream, flush=True)

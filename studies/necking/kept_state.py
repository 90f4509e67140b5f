"""The state of a run that is on its way, in a file from which another process goes on."""

import time
from pathlib import Path

import numpy as np

from core_models.atomic import replacing
from core_models.checkpoint import Checkpoint
from core_models.compilation import source_hash
from studies.output.kept_file import DAMAGE

SOURCES = "sources"
EVERY = 5.0  # s of work between two states


class KeptState:
    """A file that holds the last state of a run that was written down.

    path : of the file; None to keep nothing.
    """

    def __init__(self, path: Path | None) -> None:
        self.path = path
        self._written = time.monotonic()

    def read(self) -> Checkpoint | None:
        """The state; None without one, and for one that is damaged or of other sources, which would go on otherwise."""
        if self.path is None or not self.path.exists():
            return None
        try:
            with np.load(self.path, allow_pickle=False) as file:
                state = {name: file[name] for name in file.files}
        except DAMAGE:
            return None
        return state if str(state.pop(SOURCES, "")) == source_hash() else None

    def is_due(self) -> bool:
        """Whether it is time to write again."""
        return time.monotonic() - self._written >= EVERY

    def write(self, state: Checkpoint) -> None:
        """Write a state whole, or leave the one before; raises DiskFull, OutputError."""
        if self.path is None:
            return
        with replacing(self.path) as temporary, open(temporary, "wb") as file:
            np.savez(file, **state, **{SOURCES: np.array(source_hash())})
        self._written = time.monotonic()

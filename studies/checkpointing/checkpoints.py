"""Observer: writes the run down, so that it can be resumed."""

import time
from collections.abc import Sequence
from dataclasses import replace

from studies.checkpointing.checkpoint_file import FILE, Saved, Settings, Spent, write_checkpoint
from studies.checkpointing.interval import Interval
from studies.observers.observer import Observer
from studies.output.output_folder import OutputFolder


class Checkpoints(Observer):
    """Writes a checkpoint before the first step and after every interval, and removes it when the run has ended well.

    Parameters
    ----------
    folder : of the run. interval : between checkpoints. settings : of the run. observers : all others, which must have
    been told of a step before. spent : what the run has cost before this process.
    """

    def __init__(
        self,
        folder: OutputFolder,
        interval: Interval,
        settings: Settings,
        observers: Sequence[Observer],
        spent: Spent,
    ) -> None:
        self._folder, self._interval, self._settings = folder, interval, settings
        self._observers, self._spent = tuple(observers), spent
        self._wall, self._cpu = time.perf_counter(), time.process_time()

    def start(self, solver) -> None:
        """Write the beginning down."""
        self._write(solver)

    def resume(self, solver, checkpoint) -> None:
        """Count from here on: what has just been read need not be written."""
        self._count_from(solver)

    def step(self, solver) -> None:
        """Write when the interval is over."""
        if self._interval.is_over(time.monotonic() - self._written, solver.step_count - self._step):
            self._write(solver)

    def remove(self) -> None:
        """Remove the checkpoint of a run whose results are whole."""
        self._folder.file(FILE).unlink(missing_ok=True)

    def _write(self, solver) -> None:
        spent = replace(
            self._spent,
            wall_s=self._spent.wall_s + time.perf_counter() - self._wall,
            cpu_s=self._spent.cpu_s + time.process_time() - self._cpu,
        )
        kept = {type(observer).__name__: observer.checkpoint() for observer in self._observers}
        write_checkpoint(self._folder, Saved(self._settings, spent, solver.checkpoint(), kept))
        self._count_from(solver)

    def _count_from(self, solver) -> None:
        self._written, self._step = time.monotonic(), solver.step_count

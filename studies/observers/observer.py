"""What hangs on a run's loop: history, frames, progress, contact, checkpoints."""

from core_models.checkpoint import Checkpoint


class Observer:
    """Called before the first step, after every step, and once at the end; a subclass takes what it needs."""

    def start(self, solver) -> None:
        """Before the first step."""

    def resume(self, solver, checkpoint: Checkpoint) -> None:
        """In place of `start`, where a run goes on that had been written down: what `checkpoint` gave then."""

    def step(self, solver) -> None:
        """After each step."""

    def finish(self, solver) -> None:
        """After the last step of a run that reached its end."""

    def abandon(self) -> None:
        """After a run that went wrong or was interrupted: keep what there is."""

    def checkpoint(self) -> Checkpoint:
        """All that `resume` needs, after a step; nothing by default."""
        return {}

"""What hangs on a run's loop: history, frames, progress, contact, checkpoints."""


class Observer:
    """Called before the first step, after every step, and once at the end; a subclass takes what it needs."""

    def start(self, solver) -> None:
        """Before the first step."""

    def step(self, solver) -> None:
        """After each step."""

    def finish(self, solver) -> None:
        """After the last step of a run that reached its end."""

    def abandon(self) -> None:
        """After a run that went wrong or was interrupted: keep what there is."""

"""Checkpoint and restart of quasi-static increments."""

from core_models.checkpoint import Checkpoint
from core_models.restartable import Restartable


class RestartableIncrements(Restartable):
    """The half of a quasi-static solver that writes itself down and goes on from there; its log is not part of it.

    It may go on with another tolerance, and with smaller increments.
    """

    VALUES = ("_places", "_velocity", "_forces", "time", "step_count", "point_updates", "node_updates")
    PARTS = (
        ("_supports", ("reactions",)),
        ("_increments", ("next",)),
        ("_route", ("load_time", "load_rate")),
    )

    def restore(self, checkpoint: Checkpoint) -> None:
        """See `Restartable`."""
        super().restore(checkpoint)
        self._increments.limit()

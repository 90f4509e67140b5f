"""Checkpoint and restart of explicit finite elements."""

from core_models.checkpoint import Checkpoint
from core_models.restartable import Restartable


class RestartableSteps(Restartable):
    """The half of `ExplicitSolver` that writes itself down and goes on from there."""

    VALUES = (
        "positions", "velocities", "_held", "time", "step_count", "point_updates", "node_updates",
        "_last_step", "_middle", "_first_step", "wall_impulse", "wall_force",
    )  # fmt: skip
    PARTS = (
        ("_body", ("scales",)),
        ("_supports", ("reactions",)),
        ("_conduction", ("temperatures", "limit")),
    )

    def restore(self, checkpoint: Checkpoint) -> None:
        """See `Restartable`."""
        super().restore(checkpoint)
        self._resist()

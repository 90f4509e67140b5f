"""Checkpoint and restart of the explicit material point method."""

from core_models.checkpoint import Checkpoint
from core_models.restartable import Restartable


class RestartableSteps(Restartable):
    """The half of `Solver` that writes itself down and goes on from there.

    The box of the grid is part of it: the order of all sums depends on it.
    """

    VALUES = (
        "positions", "velocities", "affine", "volume_ratio", "time", "time_step", "step_count", "point_updates",
        "node_updates", "_last_step", "_first_step", "_kinetic", "_stress_power", "_ahead", "wall_impulse",
        "wall_force",
    )  # fmt: skip
    PARTS = (
        ("_background", ("box", "_beyond")),
        ("_contact", ("touched",)),
        ("_supports", ("reactions",)),
        ("_conduction", ("gradients", "limit")),
        ("_cure", ("stretch",)),
    )

    def restore(self, checkpoint: Checkpoint) -> None:
        """See `Restartable`."""
        super().restore(checkpoint)
        self._background.renew(len(self.positions))
        self._background.convect(self.points.old_deformation_gradient)
        self._filled = False

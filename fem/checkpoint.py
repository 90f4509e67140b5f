"""Checkpoint and restart of explicit finite elements."""

from core_models.checkpoint import (
    Checkpoint,
    check_fits,
    ledger_checkpoint,
    part_of,
    points_checkpoint,
    put_values,
    restore_ledger,
    restore_points,
    under,
    values_of,
)

VALUES = (
    "positions", "velocities", "_held", "time", "step_count", "point_updates", "_last_step", "_middle", "_first_step",
    "wall_impulse", "wall_force",
)  # fmt: skip
CONDUCTION = ("temperatures", "limit")


class Restartable:
    """The half of `ExplicitSolver` that writes itself down and goes on from there."""

    def checkpoint(self) -> Checkpoint:
        """Copies of everything that the steps to come depend on, between two steps."""
        conduction = {} if self._conduction is None else values_of(self._conduction, CONDUCTION)
        return {
            **values_of(self, VALUES),
            **under("points", points_checkpoint(self.points)),
            **under("body", values_of(self._body, ("scales",))),
            **under("supports", values_of(self._supports, ("reactions",))),
            **under("conduction", conduction),
            **under("ledger", ledger_checkpoint(self._ledger)),
        }

    def restore(self, checkpoint: Checkpoint) -> None:
        """Go on from a checkpoint of a solver that was built alike: the steps to come are bitwise those it would make.

        Raises SceneError for a checkpoint of another body, material or option.
        """
        check_fits(self.checkpoint(), checkpoint)
        put_values(self, VALUES, checkpoint)
        restore_points(self.points, part_of(checkpoint, "points"))
        put_values(self._body, ("scales",), part_of(checkpoint, "body"))
        put_values(self._supports, ("reactions",), part_of(checkpoint, "supports"))
        if self._conduction is not None:
            put_values(self._conduction, CONDUCTION, part_of(checkpoint, "conduction"))
        restore_ledger(self._ledger, part_of(checkpoint, "ledger"))
        self._resist()

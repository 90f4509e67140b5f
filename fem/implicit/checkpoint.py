"""Checkpoint and restart of implicit finite elements."""

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

VALUES = ("positions", "_velocity", "_forces", "time", "step_count", "point_updates")
CONDUCTION = ("temperatures",)
ROUTE = ("load_time", "load_rate")


class RestartableIncrements:
    """The half of `ImplicitSolver` that writes itself down and goes on from there; its log is not part of it."""

    def checkpoint(self) -> Checkpoint:
        """Copies of everything that the increments to come depend on: the last converged state."""
        heat = {} if self._conduction is None else values_of(self._conduction, CONDUCTION)
        return {
            **values_of(self, VALUES),
            **under("points", points_checkpoint(self.points)),
            **under("body", values_of(self._body, ("scales",))),
            **under("supports", values_of(self._supports, ("reactions",))),
            **under("conduction", heat),
            **under("route", values_of(self._route, ROUTE)),
            **under("increments", values_of(self._increments, ("next",))),
            **under("ledger", ledger_checkpoint(self._ledger)),
        }

    def restore(self, checkpoint: Checkpoint) -> None:
        """Go on from a checkpoint of a solver that was built alike: the increments to come are bitwise the same.

        Raises SceneError for a checkpoint of another body, material or option.
        """
        check_fits(self.checkpoint(), checkpoint)
        put_values(self, VALUES, checkpoint)
        restore_points(self.points, part_of(checkpoint, "points"))
        put_values(self._body, ("scales",), part_of(checkpoint, "body"))
        put_values(self._supports, ("reactions",), part_of(checkpoint, "supports"))
        if self._conduction is not None:
            put_values(self._conduction, CONDUCTION, part_of(checkpoint, "conduction"))
        put_values(self._route, ROUTE, part_of(checkpoint, "route"))
        put_values(self._increments, ("next",), part_of(checkpoint, "increments"))
        restore_ledger(self._ledger, part_of(checkpoint, "ledger"))

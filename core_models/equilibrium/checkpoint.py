"""Checkpoint and restart of quasi-static increments."""

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

VALUES = ("_places", "_velocity", "_forces", "time", "step_count", "point_updates")


class RestartableIncrements:
    """The half of a quasi-static solver that writes itself down and goes on from there; its log is not part of it.

    OWN : attributes of the solver, or of its parts, that it needs besides: name of the part, names of the attributes.
    A part that the solver does without is None.
    """

    OWN: tuple[tuple[str, tuple[str, ...]], ...] = ()

    def checkpoint(self) -> Checkpoint:
        """Copies of everything that the increments to come depend on: the last converged state."""
        own = [
            under(part.lstrip("_"), values_of(getattr(self, part), names)) for part, names in self._parts()
        ]
        return {
            **values_of(self, VALUES),
            **under("points", points_checkpoint(self.points)),
            **under("ledger", ledger_checkpoint(self._ledger)),
            **{name: value for part in own for name, value in part.items()},
        }

    def restore(self, checkpoint: Checkpoint) -> None:
        """Go on from a checkpoint of a solver that was built alike: the increments to come are bitwise the same.

        Raises SceneError for a checkpoint of another body, material or option.
        """
        check_fits(self.checkpoint(), checkpoint)
        put_values(self, VALUES, checkpoint)
        restore_points(self.points, part_of(checkpoint, "points"))
        restore_ledger(self._ledger, part_of(checkpoint, "ledger"))
        for part, names in self._parts():
            put_values(getattr(self, part), names, part_of(checkpoint, part.lstrip("_")))

    def _parts(self) -> tuple[tuple[str, tuple[str, ...]], ...]:
        parts = (
            ("_supports", ("reactions",)),
            ("_increments", ("next",)),
            ("_route", ("load_time", "load_rate")),
            *self.OWN,
        )
        return tuple(each for each in parts if getattr(self, each[0]) is not None)

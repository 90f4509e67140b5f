"""Checkpoint and restart of a solver whose state is values of its own, of its points and of named parts."""

from dataclasses import fields

from core_models.checkpoint import (
    Checkpoint,
    check_fits,
    part_of,
    points_checkpoint,
    put_values,
    restore_points,
    under,
    values_of,
)
from core_models.ledger import EnergyLedger

Parts = tuple[tuple[str, tuple[str, ...]], ...]

LEDGER = ("_ledger", tuple(term.name for term in fields(EnergyLedger)))


class Restartable:
    """The half of a solver that writes itself down and goes on from there.

    VALUES : names of its own attributes. PARTS : attributes that are objects, and names of theirs; a part that the
    solver does without is None.
    """

    VALUES: tuple[str, ...] = ()
    PARTS: Parts = ()

    def checkpoint(self) -> Checkpoint:
        """Copies of everything that the steps to come depend on: the state after the last complete one."""
        checkpoint = {
            **values_of(self, self.VALUES),
            **under("points", points_checkpoint(self.points)),
        }
        for part, names in self._parts():
            checkpoint |= under(part.lstrip("_"), values_of(getattr(self, part), names))
        return checkpoint

    def restore(self, checkpoint: Checkpoint) -> None:
        """Go on from a checkpoint of a solver that was built alike: the steps to come are bitwise those it would make.

        Raises SceneError for a checkpoint of another body, material or option.
        """
        check_fits(self.checkpoint(), checkpoint)
        put_values(self, self.VALUES, checkpoint)
        restore_points(self.points, part_of(checkpoint, "points"))
        for part, names in self._parts():
            put_values(getattr(self, part), names, part_of(checkpoint, part.lstrip("_")))

    def _parts(self) -> Parts:
        return tuple(each for each in (LEDGER, *self.PARTS) if getattr(self, each[0]) is not None)

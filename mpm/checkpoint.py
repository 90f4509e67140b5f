"""Checkpoint and restart of the explicit material point method."""

import numpy as np

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
    "positions", "velocities", "affine", "volume_ratio", "time", "time_step", "step_count", "point_updates",
    "_last_step", "_first_step", "_kinetic", "_stress_power", "_ahead", "wall_impulse", "wall_force",
)  # fmt: skip
CONDUCTION = ("gradients", "limit")
CURE = ("stretch",)


class Restartable:
    """The half of `Solver` that writes itself down and goes on from there."""

    def checkpoint(self) -> Checkpoint:
        """Copies of everything that the steps to come depend on, between two steps."""
        conduction = {} if self._conduction is None else values_of(self._conduction, CONDUCTION)
        cure = {} if self._cure is None else values_of(self._cure, CURE)
        still = np.zeros(self.mesh.dimension)
        reactions = {name: self._reactions.get(name, still).copy() for name in self._supports.names}
        return {
            **values_of(self, VALUES),
            **under("points", points_checkpoint(self.points)),
            **under("background", self._background.checkpoint()),
            **under("contact", {} if self._contact is None else {"touched": self._contact.touched.copy()}),
            **under("reactions", reactions),
            **under("conduction", conduction),
            **under("cure", cure),
            **under("ledger", ledger_checkpoint(self.ledger)),
        }

    def restore(self, checkpoint: Checkpoint) -> None:
        """Go on from a checkpoint of a solver that was built alike: the steps to come are bitwise those it would make.

        Raises SceneError for a checkpoint of another body, material or option.
        """
        check_fits(self.checkpoint(), checkpoint)
        put_values(self, VALUES, checkpoint)
        restore_points(self.points, part_of(checkpoint, "points"))
        self._background.restore(part_of(checkpoint, "background"), len(self.positions))
        if self._contact is not None:
            self._contact.restore(checkpoint["contact.touched"])
        self._reactions = {name: value.copy() for name, value in part_of(checkpoint, "reactions").items()}
        if self._conduction is not None:
            put_values(self._conduction, CONDUCTION, part_of(checkpoint, "conduction"))
        if self._cure is not None:
            put_values(self._cure, CURE, part_of(checkpoint, "cure"))
        self._background.convect(self.points.old_deformation_gradient)
        restore_ledger(self.ledger, part_of(checkpoint, "ledger"))
        self._filled = False

"""The course of a run: what has been measured and spent until now, written down and gone on from."""

import time
from typing import Self

import numpy as np

from core_models.checkpoint import Checkpoint, part_of, under
from core_models.equilibrium.order import newton_orders
from studies.methods.quasi_static import KineticWatch
from studies.necking.bar_necking import NeckingWatch
from studies.necking.kept_state import KeptState
from studies.necking.run import NeckingRun, shape_of


class Course:
    """What a run consists of besides its loop, which is a block of this: what ends it, the state is kept.

    watch, kinetic : of the solver; a static run is not watched for kinetic energy. state : where it is kept, and what
    the run goes on from. began : processor time of this process at which the run began [s].
    """

    def __init__(
        self, solver, watch: NeckingWatch, state: KeptState, began: float, kinetic: KineticWatch | None = None
    ) -> None:
        self.solver, self.watch, self.kinetic = solver, watch, kinetic
        self._state, self._began = state, began
        self._before: Checkpoint = {
            "seconds": np.zeros(()), "iterations": np.zeros((), int), "cuts": np.zeros((), int), "orders": np.zeros(0)
        }  # fmt: skip
        self._last: Checkpoint = {}
        kept = state.read()
        if kept is not None:
            self._restore(kept)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: type[BaseException] | None, *_: object) -> None:
        if kind is not None:
            self._write()

    def row(self, force: float) -> None:
        """Take a row for the solver's state and a force [N]; the run can go on from here."""
        self.watch.add(self.solver, force)
        self._last = under("solver", self.solver.checkpoint()) | under("watch", self.watch.checkpoint())
        if self.kinetic is not None:
            # What flies off a bar that breaks is no longer slow.
            if not self.watch.history.column("failed")[-1]:
                self.kinetic.look(self.solver)
            self._last["share"] = np.array(self.kinetic.share)
        if self._state.is_due():
            self._write()

    def run(self, stopped: str = "") -> NeckingRun:
        """The run as it is now."""
        spent = self._spent()
        share = 0.0 if self.kinetic is None else self.kinetic.share
        return NeckingRun(
            self.watch.history, *shape_of(self.solver), float(spent["seconds"]), self.solver.step_count, share,
            int(spent["iterations"]), int(spent["cuts"]), tuple(spent["orders"].tolist()), stopped,
        )  # fmt: skip

    def _spent(self) -> Checkpoint:
        """Processor time [s] and the counts of Newton's method, with those of the processes before."""
        here = {"seconds": time.process_time() - self._began, "iterations": 0, "cuts": 0, "orders": []}
        if self.kinetic is None:
            log = self.solver.log
            here |= {"iterations": len(log.iterations), "cuts": len(log.cuts), "orders": newton_orders(log)}
        orders = np.concatenate([self._before["orders"], here.pop("orders")])
        return {name: self._before[name] + value for name, value in here.items()} | {"orders": orders}

    def _write(self) -> None:
        if self._last:
            self._state.write(self._last | under("spent", self._spent()))

    def _restore(self, kept: Checkpoint) -> None:
        self.solver.restore(part_of(kept, "solver"))
        self.watch.restore(part_of(kept, "watch"))
        self._before = part_of(kept, "spent")
        if self.kinetic is not None:
            self.kinetic.share = float(kept["share"])

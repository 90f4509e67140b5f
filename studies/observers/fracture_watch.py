"""Observer: whether the particles of a body have come apart on the grid before its material has."""

import logging
from typing import Any

import numpy as np

from core_models.checkpoint import Checkpoint
from studies.observers.observer import Observer

EVERY = 50  # steps: it looks at all pairs of neighbours, which costs as much as a part of a step

logger = logging.getLogger(__name__)


class FractureWatch(Observer):
    """found : None, or what was seen first: time [s], pairs of neighbours, place (d,) [m] and stretch of the widest."""

    def __init__(self) -> None:
        self.found: dict[str, Any] | None = None

    def step(self, solver) -> None:
        """Look now and then until something is found."""
        if solver.step_count % EVERY == 0:
            self._look(solver)

    def finish(self, solver) -> None:
        """Look at the end."""
        self._look(solver)

    def resume(self, solver, checkpoint: Checkpoint) -> None:
        """Go on with what had been seen."""
        if checkpoint["seen"].size:
            time, pairs, stretch, *position = (float(x) for x in checkpoint["seen"])
            self.found = {"time": time, "pairs": int(pairs), "position": position, "stretch": stretch}

    def checkpoint(self) -> Checkpoint:
        """What has been seen, if anything."""
        found = self.found
        seen = [] if found is None else [found["time"], found["pairs"], found["stretch"], *found["position"]]
        return {"seen": np.array(seen, dtype=np.float64)}

    def _look(self, solver) -> None:
        look = getattr(solver, "numerical_fracture", None)
        if look is None or self.found is not None:
            return
        fracture = look()
        if fracture is not None:
            self.found = {"time": solver.time, **fracture._asdict(), "position": list(fracture.position)}
            logger.warning("%s", fracture_text(self.found))


def fracture_text(found: dict[str, Any]) -> str:
    """One line about what was found."""
    place = ", ".join(f"{x:.4g}" for x in found["position"])
    return (
        f"numerical fracture from t = {found['time']:.4e} s on: {found['pairs']} pairs of neighbouring particles share "
        f"no node any more, first round ({place}) m, {found['stretch']:.3g} times as far apart as they were; use "
        "configuration 'total' or interpolation 'cpdi'"
    )

"""How often a run writes itself down: after some time, or after some steps."""

import re
from dataclasses import dataclass

from core_models.errors import SceneError

SECONDS = {"s": 1.0, "min": 60.0, "h": 3600.0}


@dataclass(frozen=True)
class Interval:
    """Between two checkpoints: seconds [s] of work, or a number of steps; one of them is None."""

    seconds: float | None = None
    steps: int | None = None

    def is_over(self, seconds: float, steps: int) -> bool:
        """Whether so much since the last checkpoint is enough."""
        return seconds >= self.seconds if self.steps is None else steps >= self.steps


USUAL = Interval(seconds=60.0)


def read_interval(text: str) -> Interval:
    """The interval of a text like '60s', '10min', '2h' or '500steps'; SceneError for any other."""
    found = re.fullmatch(r"([0-9]{1,9})\s*(s|min|h|steps)", text.strip())
    if not found or int(found[1]) == 0:
        raise SceneError(f"'{text}' says not how often: write it like 60s, 10min, 2h or 500steps")
    number, unit = int(found[1]), found[2]
    return Interval(steps=number) if unit == "steps" else Interval(seconds=number * SECONDS[unit])


def interval_text(interval: Interval) -> str:
    """The text that `read_interval` reads as this."""
    return f"{interval.seconds:.0f}s" if interval.steps is None else f"{interval.steps}steps"

"""How long the runs of a comparison still take, from those that have been made and the one that is on."""

import time
from collections.abc import Sequence

from studies.methods.variants import read_variant


class Remaining:
    """The runs of a plan, method and resolution of each, in their order.

    A run's work is taken as the cube of its resolution, in three dimensions its fourth power: of points and of steps.
    Seconds for a unit of work are those of the method's last run, or the mean of the others while it has made none.
    """

    def __init__(self, plan: Sequence[tuple[str, int]]) -> None:
        self._plan = list(plan)
        self._done = 0
        self._paces: dict[str, float] = {}
        self._began = time.monotonic()

    @property
    def place(self) -> str:
        """Which run is on, of how many: '2/6'."""
        return f"{self._done + 1}/{len(self._plan)}"

    @property
    def is_one(self) -> bool:
        """Whether there is but one run."""
        return len(self._plan) == 1

    def begin(self) -> None:
        """The clock of the next run starts."""
        self._began = time.monotonic()

    def end(self, *, made: bool) -> None:
        """The run has ended; made : whether now, or it was there before and took no time."""
        if made:
            self._paces[self._plan[self._done][0]] = self._spent / _work(*self._plan[self._done])
        self._done += 1

    def left(self, share: float) -> tuple[float, float]:
        """Seconds that this run and all runs still take, when a share in (0, 1] of this one is done."""
        method, resolution = self._plan[self._done]
        paces = self._paces | {method: self._spent / (share * _work(method, resolution))}
        usual = sum(paces.values()) / len(paces)
        later = sum(paces.get(job[0], usual) * _work(*job) for job in self._plan[self._done + 1 :])
        own = self._spent * (1.0 - share) / share
        return own, own + later

    @property
    def _spent(self) -> float:
        return time.monotonic() - self._began


def _work(method: str, resolution: int) -> float:
    return float(resolution) ** (4 if read_variant(method).is_spatial else 3)

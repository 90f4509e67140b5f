"""When a run ends."""

from studies.observers.contact_watch import ContactWatch
from studies.scenes.scene import Scene


class Ending:
    """Ends at the scene's time, or one axial period after the last touch while the bar flies off.

    A rebound that only pauses is no release: the period starts again with every touch, and the bar as a whole
    must move away from the wall.
    """

    def __init__(self, scene: Scene, wall: str, contact: ContactWatch) -> None:
        self._limit = scene.end.limit(wall)
        self._period = scene.axial_period if scene.end.after_release(wall) else None
        self._contact = contact

    def reached(self, solver) -> bool:
        """Whether the run is over."""
        return solver.time >= self._limit or self.released(solver)

    def released(self, solver) -> bool:
        """Whether the bar left the wall at least one axial period ago."""
        if self._period is None or self._contact.last is None:
            return False
        return solver.time >= self._contact.last + self._period and solver.momentum[-1] > 0.0

    def next_stop(self, solver) -> float:
        """The next time at which the run may be over [s]: no step shall pass it."""
        if self._period is None or self._contact.last is None:
            return self._limit
        release = self._contact.last + self._period
        return min(self._limit, release) if release > solver.time else self._limit

    def expected(self, solver) -> float:
        """Best guess of the end time now [s]."""
        if self._period is None or self._contact.last is None or solver.in_contact:
            return self._limit
        return min(self._limit, self._contact.last + self._period)

    def reason(self, solver) -> str:
        """Why the run ended, in words."""
        if self.released(solver):
            return f"one axial period after the bar left the wall at {self._contact.last * 1e6:.4g} µs"
        if self._period is not None:
            return f"at the latest time, {self._limit * 1e6:.4g} µs, before the bar had left for one axial period"
        return f"at the end time, {self._limit * 1e6:.4g} µs"

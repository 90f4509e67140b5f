"""Sizes of increments: cut on failure, grown on ease."""

import math

from core_models.errors import NoEquilibrium, SceneError

CUT, GROWTH = 0.5, 1.5
EASY = 6  # corrections up to which an increment counts as easy
SMALLEST = 1e-6  # of the increment asked for, unless given
SAME = 1e-9  # relative difference of increments that only round-off makes


class Increments:
    """The increments of a quasi-static run.

    largest : the increment asked for [s], > 0, which growth does not exceed. smallest : below it the run gives up [s].
    """

    def __init__(self, largest: float, smallest: float | None) -> None:
        if not 0.0 < largest < math.inf:
            raise SceneError(f"increment = {largest:g} s is out of range: give a finite number above 0")
        self._largest = largest
        self._smallest = SMALLEST * largest if smallest is None else smallest
        if not 0.0 < self._smallest <= largest:
            raise SceneError(
                f"smallest = {self._smallest:g} s is out of range: give a number above 0 and up to {largest:g} s"
            )
        self.next = largest

    def limit(self) -> None:
        """Make the next increment no larger than asked for, after it has been set from outside."""
        self.next = min(self.next, self._largest)

    def cut(self, step: float, reason: str) -> float:
        """The smaller increment to try after one of `step` has failed; NoEquilibrium below the smallest."""
        smaller = CUT * step
        if smaller < self._smallest * (1.0 - SAME):
            raise NoEquilibrium(
                f"{reason}; the increment of {step:.3e} s would be cut below {self._smallest:.3e} s. The last "
                "converged state is kept"
            )
        self.next = smaller
        return smaller

    def converged(self, step: float, corrections: int) -> None:
        """Choose the next increment after one of `step` that took so many corrections."""
        if corrections <= EASY:
            # A step shortened to meet a given time says nothing about what would have been possible.
            self.next = min(self._largest, max(self.next, step * GROWTH))

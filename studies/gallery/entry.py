"""One entry of the gallery: how its picture is made, and the number that comes with it."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple


class Shown(NamedTuple):
    """What an entry has made: a picture as an SVG document, and its number."""

    picture: str
    number: float


@dataclass(frozen=True)
class Entry:
    """A picture with its words and its number.

    name : of its picture's file. text : what is seen. command : what gives the same. number : what is asserted, in
    words. expected, tolerance : in `unit`. make : makes the picture and the number.
    """

    name: str
    title: str
    text: str
    command: str
    number: str
    expected: float
    tolerance: float
    unit: str
    make: Callable[[], Shown]

    def holds(self, number: float) -> bool:
        """Whether a number lies within the tolerance."""
        return abs(number - self.expected) <= self.tolerance

    @property
    def assertion(self) -> str:
        """The number as text."""
        return f"{self.number}: {self.expected:g} ± {self.tolerance:g} {self.unit}".rstrip()

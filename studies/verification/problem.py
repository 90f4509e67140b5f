"""A verification problem: what it asks, where it comes from, and how it is run."""

from collections.abc import Callable
from dataclasses import dataclass

from studies.verification.outcome import Outcome


@dataclass(frozen=True)
class Problem:
    """A problem with a known answer.

    name : for the command line. title, description : for the reader. source : of the answer.
    run : takes whether to be quick (fewer and coarser runs, the same criteria) and returns the outcome.
    """

    name: str
    title: str
    description: str
    source: str
    run: Callable[[bool], Outcome]

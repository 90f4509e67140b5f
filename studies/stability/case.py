"""A hard case: how its solver is made, and how far it is run."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

LARGEST_DRIFT = (
    0.1  # of the energy: more, or any that is no number, is an instability that nothing has caught
)


@dataclass(frozen=True)
class Case:
    """A hard case.

    build : makes the solver of a variant (studies.methods.variants). end : time to run to [s]; steps : most steps,
    quickly a tenth of them. factor : by which every stable step is multiplied.
    drift : of the energy that is allowed. implicit : whether it is one of increments, for implicit variants.
    keeps : name of a quantity that the body has to keep to a tenth of its first value, and how it is found; such a body
    has to stay in one piece as well.
    """

    name: str
    title: str
    build: Callable[[str], Any]
    end: float = float("inf")
    steps: int = 60_000
    factor: float = 1.0
    drift: float = LARGEST_DRIFT
    implicit: bool = False
    keeps: tuple[str, Callable[[Any], float]] | None = None

"""A problem of the work-precision study: what is run, and what its answers are held against."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from studies.methods.variants import Variant, read_variant


@dataclass(frozen=True)
class Reference:
    """A quantity's value [SI] with its uncertainty and source; value None: extrapolated from all runs together."""

    value: float | None
    uncertainty: float
    source: str


@dataclass(frozen=True)
class WorkProblem:
    """A problem with named quantities.

    references : by quantity. resolutions : default ones by variant or else its method word, five or more.
    build : makes the solver of a variant at a resolution with a number of threads. finish : steps it to its end,
    returns its answers. units : of the quantities. read : reads a variant's name.
    """

    name: str
    title: str
    references: dict[str, Reference]
    resolutions: dict[str, tuple[int, ...]]
    variants: tuple[str, ...]
    build: Callable[[str, int, int], Any]
    finish: Callable[[Any], dict[str, float]]
    units: dict[str, str]
    read: Callable[[str], Variant] = read_variant

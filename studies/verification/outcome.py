"""What a verification problem leaves: criteria with their verdicts, tables, figures."""

import math
from dataclasses import dataclass, field

import numpy as np

Cell = str | float | int | None


@dataclass(frozen=True)
class Criterion:
    """One thing that must hold: low <= value <= high.

    what : in words. value : measured; None where it could not be, and `reason` says why. unit : of the value.
    """

    what: str
    value: float | None
    low: float = -math.inf
    high: float = math.inf
    unit: str = ""
    reason: str = ""

    @property
    def met(self) -> bool:
        """Whether the value was measured and lies in its range; not a number lies in none."""
        return self.value is not None and bool(self.low <= self.value <= self.high)


@dataclass(frozen=True)
class Table:
    """Numbers and words; the first column names the row."""

    title: str
    head: tuple[str, ...]
    rows: tuple[tuple[Cell, ...], ...]
    note: str = ""


@dataclass(frozen=True)
class Curve:
    """One line of a plot. family : 'fem', 'mpm' or 'exact', which gives the colour."""

    label: str
    x: tuple[float, ...]
    y: tuple[float, ...]
    family: str


@dataclass(frozen=True)
class Plot:
    """Curves over one pair of axes. scattered : their points belong to no order, and no line connects them."""

    title: str
    x_label: str
    y_label: str
    curves: tuple[Curve, ...]
    logarithmic: bool = False
    scattered: bool = False


@dataclass(frozen=True)
class Picture:
    """A field on a deformed body, or on several side by side.

    label : of the values. panels : name -> domains (n, 4, 2) [m] and values (n,). limits : of the colours, or None for
    the smallest and the largest value.
    """

    title: str
    label: str
    panels: dict[str, tuple[np.ndarray, np.ndarray]]
    limits: tuple[float, float] | None = None


@dataclass
class Outcome:
    """All that a problem has to say; `remarks` are sentences for the reader."""

    criteria: list[Criterion] = field(default_factory=list)
    tables: list[Table] = field(default_factory=list)
    plots: list[Plot] = field(default_factory=list)
    remarks: list[str] = field(default_factory=list)
    pictures: list[Picture] = field(default_factory=list)
    seconds: float = 0.0

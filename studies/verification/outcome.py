"""What a verification problem leaves: criteria with their verdicts, tables, figures."""

import math
from dataclasses import dataclass, field

from studies.report.parts import Picture, Plot, Table


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


@dataclass
class Outcome:
    """All that a problem has to say; `remarks` are sentences for the reader."""

    criteria: list[Criterion] = field(default_factory=list)
    tables: list[Table] = field(default_factory=list)
    plots: list[Plot] = field(default_factory=list)
    remarks: list[str] = field(default_factory=list)
    pictures: list[Picture] = field(default_factory=list)
    seconds: float = 0.0

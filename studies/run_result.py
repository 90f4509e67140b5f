"""What comes of a run, as one object."""

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from core_models.errors import DiskFull, RunFailure
from studies.costs import Cost
from studies.history import History
from studies.scene import Scene
from studies.taylor_impact import Quantity


@dataclass(frozen=True)
class FinalState:
    """What the report draws: domains (n,4,2) and where their points began (n,2) [m], fields by name, outline [m]."""

    domains: np.ndarray
    reference: np.ndarray
    fields: dict[str, np.ndarray]
    outline: dict[str, np.ndarray]


@dataclass
class RunResult:
    """A run; when it went wrong `failure` is set and quantities and final state are missing.

    resumed: how often it went on from a checkpoint; ended: why the run ended; conservation: relative errors of
    mass, momentum, energy; energies [J]; numerical_fracture: what `FractureWatch` has found, or None.
    """

    scene: Scene
    method: str
    resolution: int
    wall: str
    threads: int
    history: History
    cost: Cost
    resumed: int = 0
    failure: RunFailure | DiskFull | None = None
    ended: str = ""
    points: int = 0
    quantities: dict[str, Quantity] = field(default_factory=dict)
    conservation: dict[str, float] = field(default_factory=dict)
    energies: dict[str, float] = field(default_factory=dict)
    numerical_fracture: dict[str, Any] | None = None
    final: FinalState | None = None

    @property
    def status(self) -> str:
        """'complete' or 'failed'."""
        return "complete" if self.failure is None else "failed"

    @property
    def label(self) -> str:
        """Short name: method and resolution."""
        return f"{self.method} {self.resolution}"

"""What comes of a run, as one object."""

from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from core_models.errors import DiskFull, RunFailure
from studies.bar.taylor_impact import Quantity
from studies.observers.history import History
from studies.runs.costs import Cost
from studies.scenes.scene import Scene


@dataclass(frozen=True)
class FinalState:
    """What the report draws: domains (n,4,2) [m], fields by name, outline by part [m].

    reference (n, 2) : places (r, z) in the undeformed bar, above its foot [m]. volumes (n,) : undeformed [m^3].
    """

    domains: np.ndarray
    fields: dict[str, np.ndarray]
    outline: dict[str, np.ndarray]
    reference: np.ndarray
    volumes: np.ndarray


@dataclass
class RunResult:
    """A run; when it went wrong `failure` is set and quantities and final state are missing.

    folder: where it is kept, or None; resumed: how often it went on from a checkpoint; ended: why the run ended;
    conservation: relative errors of mass, momentum, energy; energies [J]; numerical_fracture: what `FractureWatch`
    has found, or None.
    """

    scene: Scene
    method: str
    resolution: int
    wall: str
    threads: int
    history: History
    cost: Cost
    folder: Path | None = None
    resumed: int = 0
    failure: RunFailure | DiskFull | None = None
    ended: str = ""
    points: int = 0
    quantities: dict[str, Quantity] = field(default_factory=dict)
    conservation: dict[str, float] = field(default_factory=dict)
    energies: dict[str, float] = field(default_factory=dict)
    numerical_fracture: dict[str, Any] | None = None
    final: FinalState | None = None

    def _repr_html_(self) -> str:
        """As a notebook shows it."""
        from studies.report.notebook import run_html

        return run_html(self)

    @property
    def status(self) -> str:
        """'complete' or 'failed'."""
        return "complete" if self.failure is None else "failed"

    @property
    def label(self) -> str:
        """Short name: method and resolution."""
        return f"{self.method} {self.resolution}"

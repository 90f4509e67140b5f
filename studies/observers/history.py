"""Observer: the run over time, as columns, kept in history.csv."""

import numpy as np

from core_models.checkpoint import Checkpoint
from studies.bar.outline import bar_outline
from studies.bar.shape import foot_radius, length, rim_lift
from studies.observers.observer import Observer
from studies.output.output_folder import OutputFolder

ENERGIES = ("kinetic", "strain", "plastic", "viscosity", "transfer", "contact", "friction", "hourglass")
COLUMNS = (
    "t",
    "dt",
    *ENERGIES,
    "total",
    "momentum",
    "wall_impulse",
    "wall_force",
    "length",
    "foot_radius",
    "rim_lift",
)


class History(Observer):
    """Samples the solver at even times; saves the table with every tenth of the samples, atomically.

    wall_force is the mean over the time since the row before [N]; energies in J; axial momentum and impulse in N s.
    """

    def __init__(self, folder: OutputFolder | None, end: float, samples: int = 400) -> None:
        self._folder = folder
        self._interval = end / samples
        self._rows_per_save = max(samples // 10, 1)
        self._rows: list[tuple[float, ...]] = []
        self._next = 0.0

    def column(self, name: str) -> np.ndarray:
        """One column as an array (k,)."""
        return np.array([row[COLUMNS.index(name)] for row in self._rows])

    def start(self, solver) -> None:
        """Sample the initial state."""
        self._sample(solver)

    def resume(self, solver, checkpoint: Checkpoint) -> None:
        """Go on with the rows sampled so far."""
        self._rows = [tuple(row) for row in checkpoint["rows"].tolist()]
        self._next = float(checkpoint["next"])

    def checkpoint(self) -> Checkpoint:
        """Rows and next sampling time."""
        return {"rows": np.array(self._rows), "next": np.array(self._next)}

    def step(self, solver) -> None:
        """Sample when the next sampling time has come."""
        if solver.time >= self._next:
            self._sample(solver)
            if len(self._rows) % self._rows_per_save == 0:
                self._save()

    def finish(self, solver) -> None:
        """Sample the final state and save."""
        if solver.time > self._rows[-1][0]:
            self._sample(solver)
        self._save()

    def abandon(self) -> None:
        """Save the samples taken so far."""
        self._save()

    def _sample(self, solver) -> None:
        self._next = (np.floor(solver.time / self._interval) + 1.0) * self._interval
        ledger, outline = solver.ledger, bar_outline(solver)
        energies = [getattr(ledger, name) for name in ENERGIES]
        row = (
            solver.time,
            solver.time_step,
            *energies,
            sum(energies),
            solver.momentum[-1],
            solver.wall_impulse,
            self._mean_force(solver),
            length(outline),
            foot_radius(outline),
            rim_lift(outline),
        )
        self._rows.append(tuple(float(value) for value in row))

    def _mean_force(self, solver) -> float:
        if not self._rows:
            return 0.0
        before = dict(zip(COLUMNS, self._rows[-1], strict=True))
        return (solver.wall_impulse - before["wall_impulse"]) / (solver.time - before["t"])

    def _save(self) -> None:
        if self._folder is None:
            return
        lines = [",".join(COLUMNS), *(",".join(f"{value:.9g}" for value in row) for row in self._rows)]
        self._folder.write_text("history.csv", "\n".join(lines) + "\n")

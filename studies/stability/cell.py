"""One cell of the matrix: a case by a variant, run and judged."""

import logging
import math
import time
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from core_models.errors import MatpointError
from studies.stability.case import LARGEST_DRIFT, Case

STABLE, RESCUED, REFUSED, FAILED = "stable", "stable after redoing steps", "refused", "failed"
QUICKLY = 10  # times fewer steps
WATCH = 50  # looks at the body in a run


@dataclass
class Cell:
    """How a case went: verdict, why; steps, time [s]; largest energy error, smallest and largest J, smallest step [s],
    redone steps; pairs of neighbouring particles that have parted (mpm.fracture); processor time with compiling [s].
    """

    case: str
    variant: str
    verdict: str = STABLE
    why: str = ""
    steps: int = 0
    time: float = 0.0
    drift: float = 0.0
    smallest_ratio: float = 1.0
    largest_ratio: float = 1.0
    smallest_step: float = math.inf
    redone: int = 0
    parted: int = 0
    seconds: float = 0.0


class _Redone(logging.Handler):
    """Counts the steps that were redone, as the policy for them logs them."""

    def __init__(self) -> None:
        super().__init__(logging.INFO)
        self.count = 0

    def emit(self, record: logging.LogRecord) -> None:
        self.count += 1


def run_cell(case: Case, variant: str, quick: bool) -> Cell:
    """Run a case by a variant; typed errors are refusals, whatever else happens is a failure."""
    cell, redone, start = Cell(case.name, variant), _Redone(), time.process_time()
    logger = logging.getLogger("core_models.redo")
    level = logger.level
    logger.addHandler(redone)
    logger.setLevel(logging.INFO)
    solver = None
    try:
        solver = case.build(variant)
        _advance(case, solver, cell, case.steps // QUICKLY if quick else case.steps)
        redone.count += _cuts(solver)
    except MatpointError as error:
        cell.verdict, cell.why = REFUSED, str(error)
    except Exception as error:
        cell.verdict, cell.why = FAILED, f"{type(error).__name__}: {error}"
    finally:
        logger.removeHandler(redone)
        logger.setLevel(level)
    if solver is not None and cell.verdict == REFUSED:
        _look(solver, cell)
    cell.redone, cell.seconds = redone.count, time.process_time() - start
    if cell.verdict == STABLE and not cell.drift <= case.drift:
        cell.verdict, cell.why = FAILED, f"the energy is off by {100.0 * cell.drift:.3g} %"
    elif cell.verdict == STABLE and cell.why:
        cell.verdict = FAILED
    elif cell.verdict == STABLE and cell.redone:
        cell.verdict = RESCUED
    return cell


def _cuts(solver: Any) -> int:
    """Increments that an implicit solver has cut; 0 for others."""
    return len(solver.log.cuts) if hasattr(solver, "log") else 0


def _advance(case: Case, solver: Any, cell: Cell, steps: int) -> None:
    first = case.keeps[1](solver) if case.keeps else 0.0
    while solver.time < case.end and cell.steps < steps:
        if case.factor != 1.0:
            solver.time_step *= case.factor
        before = solver.time
        solver.advance(case.end)
        cell.steps, cell.time = solver.step_count, solver.time
        if solver.time < case.end:
            cell.smallest_step = min(cell.smallest_step, solver.time - before)
        if cell.steps % max(steps // WATCH, 1) == 0 or cell.steps < WATCH:
            _look(solver, cell)
            cell.why = _missing(case, solver, cell, first)
            if cell.why or not cell.drift <= case.drift:
                return
    _look(solver, cell)
    cell.why = _missing(case, solver, cell, first)


def _look(solver: Any, cell: Cell) -> None:
    cell.drift = max(cell.drift, energy_drift(solver))
    cell.smallest_ratio = min(cell.smallest_ratio, float(solver.points.volume_ratio.min()))
    cell.largest_ratio = max(cell.largest_ratio, float(solver.points.volume_ratio.max()))
    fracture = solver.numerical_fracture() if hasattr(solver, "numerical_fracture") else None
    cell.parted = 0 if fracture is None else fracture.pairs


def _missing(case: Case, solver: Any, cell: Cell, first: float) -> str:
    """What the body has lost of what it has to keep, `first` of it at the start; nothing where it has kept all."""
    if case.keeps is None:
        return ""
    name, quantity = case.keeps
    kept = quantity(solver) / first
    if not abs(kept - 1.0) <= LARGEST_DRIFT:
        return f"{100.0 * kept:.3g} % of the {name} is left at t = {solver.time:.4g} s"
    if cell.parted:
        return (
            f"numerical fracture: {cell.parted} pairs of particles have come apart by t = {solver.time:.4g} s"
        )
    return ""


def energy_drift(solver: Any) -> float:
    """How much the energy is off, relative to what there was or came in; infinite where a number is none."""
    drift = abs(solver.ledger.relative_error)
    return drift if np.isfinite(solver.point_positions()).all() and math.isfinite(drift) else math.inf


def as_json(cell: Cell) -> dict[str, Any]:
    """Plain data; no number that JSON does not have."""
    return {
        name: None if isinstance(value, float) and not math.isfinite(value) else value
        for name, value in asdict(cell).items()
    }

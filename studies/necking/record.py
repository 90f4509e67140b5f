"""A necking run as JSON and back."""

from pathlib import Path
from typing import Any

import numpy as np

from studies.necking.bar_necking import NeckingHistory
from studies.necking.kept_state import KeptState
from studies.necking.methods import IMPLICIT, make_run
from studies.necking.reader import read_necking_scene
from studies.necking.run import NeckingRun
from studies.necking.scene import PlannedRun
from studies.sweep.job import failed

DIGITS = 7  # of the final shape's coordinates [m] and strains


def perform_run(scene_name: str, run_name: str, state: str | None = None) -> dict[str, Any]:
    """Make a run of a scene, as plain data; one that stops on its way has failed, with what it found until then.

    state : file that it is written down to on its way, and goes on from. Raises MatpointError for a run that cannot be.
    """
    scene = read_necking_scene(scene_name)
    plan = next(plan for plan in scene.runs if plan.name == run_name)
    run = make_run(scene, plan, KeptState(None if state is None else Path(state)))
    return (failed(run_name, _why(plan, run)) if run.stopped else {}) | {
        "asked": asked(plan),
        "columns": NeckingHistory.COLUMNS,
        "rows": run.history.rows,
        "shape": np.round(run.shape, DIGITS).tolist(),
        "strains": np.round(run.strains, DIGITS - 3).tolist(),
        "seconds": run.seconds,
        "steps": run.steps,
        "kinetic_share": run.kinetic_share,
        "iterations": run.iterations,
        "cuts": run.cuts,
        "orders": run.orders,
    }


def asked(plan: PlannedRun) -> list[float | None]:
    """What an unfinished run may go on with in another way, but a finished one is made again for."""
    return [plan.increments, plan.options.get("tolerance")]


def _why(plan: PlannedRun, run: NeckingRun) -> str:
    reached = 1e3 * float(run.history.column("elongation")[-1])
    remedy = (
        "after more increments or another tolerance have been written into the scene; or try another method"
        if plan.method in IMPLICIT
        else "and does the same again: try another mesh or method"
    )
    return f"{run.stopped}. The state at {reached:.4g} mm is kept: --resume goes on from there, {remedy}"


def run_from(record: dict[str, Any]) -> NeckingRun:
    """The run of a record."""
    return NeckingRun(
        NeckingHistory(record["rows"]), np.array(record["shape"]), np.array(record["strains"]), record["seconds"],
        record["steps"], record["kinetic_share"], record["iterations"], record["cuts"], tuple(record["orders"]),
        record["message"],
    )  # fmt: skip

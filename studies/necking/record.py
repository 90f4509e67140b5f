"""A necking run as JSON and back."""

from typing import Any

import numpy as np

from studies.bar_necking import NeckingHistory
from studies.necking.reader import read_necking_scene
from studies.necking_methods import NeckingRun, make_run
from studies.sweep.job import failed

DIGITS = 7  # of the final shape's coordinates [m] and strains


def perform_run(scene_name: str, run_name: str) -> dict[str, Any]:
    """Make a run of a scene, as plain data; one that stops on its way has failed, with what it found until then.

    Raises MatpointError for a run that cannot be.
    """
    scene = read_necking_scene(scene_name)
    plan = next(plan for plan in scene.runs if plan.name == run_name)
    run = make_run(scene, plan)
    return (failed(run_name, run.stopped) if run.stopped else {}) | {
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


def run_from(record: dict[str, Any]) -> NeckingRun:
    """The run of a record."""
    return NeckingRun(
        NeckingHistory(record["rows"]), np.array(record["shape"]), np.array(record["strains"]), record["seconds"],
        record["steps"], record["kinetic_share"], record["iterations"], record["cuts"], tuple(record["orders"]),
        record["message"],
    )  # fmt: skip

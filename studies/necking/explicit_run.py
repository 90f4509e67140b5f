"""A run by an explicit solver: slow enough to pass for one in equilibrium, or in real time."""

from typing import Any

from core_models.errors import RunFailure
from studies.methods.quasi_static import KineticWatch
from studies.necking.bar_necking import NeckingWatch, is_broken
from studies.necking.bodies import force_of
from studies.necking.course import Course
from studies.necking.kept_state import KeptState
from studies.necking.run import NeckingRun
from studies.necking.scene import ROUND_BAR, NeckingScene

ROWS = 140  # of the history
ELASTIC = 0.15  # share after which the body has taken up much more than its elastic start


def pull_explicitly(
    scene: NeckingScene, solver: Any, is_scaled: bool, state: KeptState, began: float
) -> NeckingRun:
    """Pull the body of a scene by an explicit solver, to the end or until it is broken.

    Goes on from `state`, which is that of a row's end. A run that goes wrong on its way, or moves too fast to be called
    quasi-static, is `stopped`; RunFailure if it does at once. is_scaled : whether its mass is, so that kinetic energy
    must stay small. began : processor time of this process at which the run began [s].
    """
    watch, kinetic = NeckingWatch(solver, scene.body == ROUND_BAR), KineticWatch(ELASTIC * scene.duration)
    course = Course(solver, watch, state, began, kinetic)
    try:
        with course:
            for row in range(len(watch.history.rows), ROWS):
                if is_broken(watch.history):
                    break
                course.row(_mean_force(solver, (row + 1) * scene.duration / ROWS))
            if is_scaled:
                kinetic.check()
    except RunFailure as reason:
        if not watch.history.rows:
            raise
        return course.run(str(reason))
    return course.run()


def _mean_force(solver: Any, end: float) -> float:
    """Go on until a time [s]; the mean of the force [N] until then, for elastic waves run through the bar."""
    began, impulse = solver.time, 0.0
    while solver.time < end:
        last = solver.time
        solver.advance(end)
        impulse += force_of(solver) * (solver.time - last)
    return impulse / (end - began)

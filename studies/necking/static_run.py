"""A run in equilibrium, increment by increment."""

from core_models.equilibrium.stepping import QuasiStatic
from core_models.errors import RunFailure
from studies.necking.bar_necking import NeckingWatch, is_broken
from studies.necking.bodies import force_of
from studies.necking.course import Course
from studies.necking.kept_state import KeptState
from studies.necking.run import NeckingRun
from studies.necking.scene import ROUND_BAR, NeckingScene


def pull_statically(scene: NeckingScene, solver: QuasiStatic, state: KeptState, began: float) -> NeckingRun:
    """Pull the body of a scene by an implicit solver, to the end or until it is broken.

    Goes on from `state`. A run that goes wrong on its way is `stopped`; RunFailure if it does at once.
    began : processor time of this process at which the run began [s].
    """
    course = Course(solver, NeckingWatch(solver, scene.body == ROUND_BAR), state, began)
    try:
        with course:
            while solver.time < scene.duration and not is_broken(course.watch.history):
                solver.advance(scene.duration)
                course.row(force_of(solver))
    except RunFailure as reason:
        if not course.watch.history.rows:
            raise
        return course.run(str(reason))
    return course.run()

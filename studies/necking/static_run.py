"""A run in equilibrium, increment by increment."""

import time
from collections.abc import Callable

from core_models.errors import RunFailure
from studies.bar_necking import NeckingWatch
from studies.necking.bodies import body_of, force_of, geometry_of, loads_of
from studies.necking.course import Course
from studies.necking.kept_state import KeptState
from studies.necking.run import NeckingRun
from studies.necking.scene import ROUND_BAR, NeckingScene, PlannedRun


def pull_statically(scene: NeckingScene, plan: PlannedRun, state: KeptState, make: Callable) -> NeckingRun:
    """Pull the body of a scene by an implicit solver; `make` takes its mesh and arguments.

    Goes on from `state`. A run that goes wrong on its way is `stopped`; RunFailure if it does at once.
    """
    began = time.process_time()
    solver = make(
        body_of(scene, plan), material=scene.material, loads=loads_of(scene, plan, scene.pull / scene.duration),
        increment=scene.duration / plan.increments, geometry=geometry_of(scene, plan), **plan.solver_options,
    )  # fmt: skip
    course = Course(solver, NeckingWatch(solver, scene.body == ROUND_BAR), state, began)
    try:
        with course:
            while solver.time < scene.duration:
                solver.advance(scene.duration)
                course.row(force_of(solver, plan))
    except RunFailure as reason:
        if not course.watch.history.rows:
            raise
        return course.run(str(reason))
    return course.run()

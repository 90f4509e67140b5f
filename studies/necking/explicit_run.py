"""A run by an explicit solver: slow enough to pass for one in equilibrium, or in real time."""

import time
from collections.abc import Callable

from core_models.errors import RunFailure
from studies.bar_necking import NeckingWatch
from studies.necking.bodies import body_of, force_of, geometry_of, loads_of, slowed
from studies.necking.course import Course
from studies.necking.kept_state import KeptState
from studies.necking.run import NeckingRun
from studies.necking.scene import ROUND_BAR, NeckingScene, PlannedRun
from studies.quasi_static import KineticWatch

ROWS = 140  # of the history
START = 0.05  # share of the duration in which the end speeds up
ELASTIC = 0.15  # share after which the body has taken up much more than its elastic start


def pull_explicitly(
    scene: NeckingScene, plan: PlannedRun, state: KeptState, make: Callable, crowd: int = 1
) -> NeckingRun:
    """Pull the body of a scene by an explicit solver; `make` takes its mesh and arguments.

    crowd : elements along for each that was asked for. Goes on from `state`, which is that of a row's end. A run that
    goes wrong on its way, or moves too fast to be called quasi-static, is `stopped`.
    """
    began = time.process_time()
    start = START * scene.duration
    speed = scene.pull / (scene.duration - 0.5 * start)
    material = slowed(scene, plan) if plan.periods > 0.0 else scene.material
    loads = loads_of(scene, plan, lambda _places, t: speed * min(t / start, 1.0))
    solver = make(
        body_of(scene, plan, crowd), material=material, loads=loads, geometry=geometry_of(scene, plan),
        **plan.solver_options,
    )  # fmt: skip
    watch, kinetic = NeckingWatch(solver, scene.body == ROUND_BAR), KineticWatch(ELASTIC * scene.duration)
    course = Course(solver, watch, state, began, kinetic)
    try:
        with course:
            for row in range(len(watch.history.rows), ROWS):
                course.row(_mean_force(solver, plan, (row + 1) * scene.duration / ROWS))
            if plan.periods > 0.0:
                kinetic.check()
    except RunFailure as reason:
        if not watch.history.rows:
            raise
        return course.run(str(reason))
    return course.run()


def _mean_force(solver, plan: PlannedRun, end: float) -> float:
    """Go on until a time [s]; the mean of the force [N] until then, for elastic waves run through the bar."""
    began, impulse = solver.time, 0.0
    while solver.time < end:
        last = solver.time
        solver.advance(end)
        impulse += force_of(solver, plan) * (solver.time - last)
    return impulse / (end - began)

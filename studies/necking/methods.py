"""The methods that a bar or strip is pulled with until it necks, by name."""

import time
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np

from core_models.equilibrium.stepping import QuasiStatic
from core_models.erosion.delete import DeletePoint
from core_models.errors import SceneError
from meshes.progression import progression
from studies.necking.bodies import body_of, geometry_of, is_solid, loads_of, slowed
from studies.necking.explicit_run import pull_explicitly
from studies.necking.kept_state import KeptState
from studies.necking.run import NeckingRun
from studies.necking.scene import NeckingScene, PlannedRun
from studies.necking.static_run import pull_statically
from studies.scenes.material_finder import with_update

DELETE = "delete"
OWN = ("body", "radius", "taper", "duration")  # of the scene that a run may have its own of
START = 0.05  # share of the duration in which the end speeds up
CROWD = 2  # elements that particles are seeded from along the axis of a cell: each holds two


def make_run(scene: NeckingScene, plan: PlannedRun, state: KeptState | None = None) -> NeckingRun:
    """One run of a scene, `stopped` where it goes wrong on its way; MatpointError for what cannot be at all.

    state : where it is written down on its way, and what it goes on from.
    """
    began = time.process_time()
    scene = scene_of(scene, plan)
    return pulled(scene, METHODS[plan.method](scene, plan), plan.periods > 0.0, state, began)


def pulled(
    scene: NeckingScene,
    solver: Any,
    is_scaled: bool,
    state: KeptState | None = None,
    began: float | None = None,
) -> NeckingRun:
    """The run that a solver makes which one of METHODS has built; its arguments are those of both ways to pull."""
    state, began = state or KeptState(None), time.process_time() if began is None else began
    if isinstance(solver, QuasiStatic):
        return pull_statically(scene, solver, state, began)
    return pull_explicitly(scene, solver, is_scaled, state, began)


def scene_of(scene: NeckingScene, plan: PlannedRun) -> NeckingScene:
    """The scene with what a run has in place of its own; SceneError where it lacks what the run asks for."""
    material = scene.material if plan.update is None else with_update(scene.material, plan.update)
    if plan.damage_radius is not None:
        material = replace(material, damage_radius=plan.damage_radius or None)
    if plan.erosion == DELETE:
        if material.erosion is None:
            raise SceneError(
                f"{scene.name}: {plan.name} deletes failed points, but its material has no <erosion>: add it, "
                "or leave out erosion"
            )
        material = replace(material, erosion=DeletePoint(material.erosion.decay_time))
    own = {name: getattr(plan, name) for name in OWN if getattr(plan, name) is not None}
    return replace(scene, material=material, **own)


def _fem_implicit(scene: NeckingScene, plan: PlannedRun) -> Any:
    import fem

    return _static(scene, plan, fem.ImplicitSolver)


def _mpm_implicit(scene: NeckingScene, plan: PlannedRun) -> Any:
    """The grid has the scene's elements as cells."""
    import mpm

    across = np.linspace(0.0, scene.radius, plan.across + 1)
    along = scene.length * progression(np.linspace(0.0, 1.0, plan.along + 1), plan.along, plan.grading)
    lines = [*[across] * (2 if is_solid(plan) else 1), along]
    return _static(scene, plan, lambda body, **options: mpm.ImplicitSolver(body, cell_size=lines, **options))


def _fem_explicit(scene: NeckingScene, plan: PlannedRun) -> Any:
    import fem

    return _explicit(scene, plan, fem.ExplicitSolver)


def _total_mpm(scene: NeckingScene, plan: PlannedRun) -> Any:
    """The grid covers the reference body."""
    return _particles(scene, plan, "total", 1)


def _updated_mpm(scene: NeckingScene, plan: PlannedRun) -> Any:
    """The grid covers the body as it is; a neck stretches the particles' domains, so that there are many to a cell."""
    return _particles(scene, plan, "updated", CROWD)


def _particles(scene: NeckingScene, plan: PlannedRun, configuration: str, crowd: int) -> Any:
    import mpm

    # The grid's nodes lie half a cell off the symmetry plane: a row of them has to lie on the end that is pulled.
    options = {"cell_size": scene.length / (plan.along + 0.5), "configuration": configuration}
    return _explicit(scene, plan, lambda body, **others: mpm.Solver(body, **options, **others), crowd)


def _static(scene: NeckingScene, plan: PlannedRun, make: Callable) -> Any:
    return make(
        body_of(scene, plan), material=scene.material, loads=loads_of(scene, plan, scene.pull / scene.duration),
        increment=scene.duration / plan.increments, geometry=geometry_of(scene, plan), **plan.solver_options,
    )  # fmt: skip


def _explicit(scene: NeckingScene, plan: PlannedRun, make: Callable, crowd: int = 1) -> Any:
    start = START * scene.duration
    speed = scene.pull / (scene.duration - 0.5 * start)
    material = slowed(scene, plan) if plan.periods > 0.0 else scene.material
    loads = loads_of(scene, plan, lambda _places, t: speed * min(t / start, 1.0))
    return make(
        body_of(scene, plan, crowd), material=material, loads=loads, geometry=geometry_of(scene, plan),
        **plan.solver_options,
    )  # fmt: skip


METHODS = {
    "fem-implicit": _fem_implicit,
    "fem-explicit": _fem_explicit,
    "mpm-tl": _total_mpm,
    "mpm-implicit": _mpm_implicit,
    "mpm": _updated_mpm,
}
"""Name of a method: what builds the solver of a run."""

IMPLICIT = ("fem-implicit", "mpm-implicit")

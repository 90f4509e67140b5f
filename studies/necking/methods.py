"""The methods that a bar or strip is pulled with until it necks, by name."""

from dataclasses import replace

import numpy as np

from core_models.erosion.delete import DeletePoint
from core_models.errors import SceneError
from meshes.progression import progression
from studies.material_finder import with_update
from studies.necking.bodies import is_solid
from studies.necking.explicit_run import pull_explicitly
from studies.necking.kept_state import KeptState
from studies.necking.run import NeckingRun
from studies.necking.scene import NeckingScene, PlannedRun
from studies.necking.static_run import pull_statically

DELETE = "delete"
OWN = ("body", "radius", "taper", "duration")  # of the scene that a run may have its own of
CROWD = 2  # elements that particles are seeded from along the axis of a cell: each holds two


def make_run(scene: NeckingScene, plan: PlannedRun, state: KeptState | None = None) -> NeckingRun:
    """One run of a scene, `stopped` where it goes wrong on its way; MatpointError for what cannot be at all.

    state : where it is written down on its way, and what it goes on from.
    """
    material = scene.material if plan.update is None else with_update(scene.material, plan.update)
    if plan.damage_radius is not None:
        material = replace(material, damage_radius=plan.damage_radius or None)
    if plan.erosion == DELETE:
        if material.erosion is None:
            raise SceneError(
                f"{scene.name}: {plan.name} deletes failed points, but its material has no <erosion>: add it, "
                "or leave out erosion"
            )
        material = replace(material, erosion=DeletePoint())
    own = {name: getattr(plan, name) for name in OWN if getattr(plan, name) is not None}
    scene = replace(scene, material=material, **own)
    return METHODS[plan.method](scene, plan, state or KeptState(None))


def _fem_implicit(scene: NeckingScene, plan: PlannedRun, state: KeptState) -> NeckingRun:
    import fem

    return pull_statically(scene, plan, state, fem.ImplicitSolver)


def _mpm_implicit(scene: NeckingScene, plan: PlannedRun, state: KeptState) -> NeckingRun:
    """The grid has the scene's elements as cells."""
    import mpm

    across = np.linspace(0.0, scene.radius, plan.across + 1)
    along = scene.length * progression(np.linspace(0.0, 1.0, plan.along + 1), plan.along, plan.grading)
    lines = [*[across] * (2 if is_solid(plan) else 1), along]
    return pull_statically(
        scene, plan, state, lambda body, **options: mpm.ImplicitSolver(body, cell_size=lines, **options)
    )


def _fem_explicit(scene: NeckingScene, plan: PlannedRun, state: KeptState) -> NeckingRun:
    import fem

    return pull_explicitly(scene, plan, state, fem.ExplicitSolver)


def _total_mpm(scene: NeckingScene, plan: PlannedRun, state: KeptState) -> NeckingRun:
    """The grid covers the reference body."""
    return _particles(scene, plan, state, "total", 1)


def _updated_mpm(scene: NeckingScene, plan: PlannedRun, state: KeptState) -> NeckingRun:
    """The grid covers the body as it is; a neck stretches the particles' domains, so that there are many to a cell."""
    return _particles(scene, plan, state, "updated", CROWD)


def _particles(
    scene: NeckingScene, plan: PlannedRun, state: KeptState, configuration: str, crowd: int
) -> NeckingRun:
    import mpm

    # The grid's nodes lie half a cell off the symmetry plane: a row of them has to lie on the end that is pulled.
    options = {"cell_size": scene.length / (plan.along + 0.5), "configuration": configuration}
    return pull_explicitly(
        scene, plan, state, lambda body, **others: mpm.Solver(body, **options, **others), crowd
    )


METHODS = {
    "fem-implicit": _fem_implicit,
    "fem-explicit": _fem_explicit,
    "mpm-tl": _total_mpm,
    "mpm-implicit": _mpm_implicit,
    "mpm": _updated_mpm,
}
"""Name of a method: what makes a run of it."""

IMPLICIT = ("fem-implicit", "mpm-implicit")

OPTIONS = {
    "fem-implicit": ("integration", "cure", "tolerance"),
    "fem-explicit": ("integration", "cure", "hourglass"),
    "mpm-tl": ("interpolation", "transfer", "cure", "seeding", "cfl"),
    "mpm-implicit": ("interpolation", "cure", "seeding", "ghost", "tolerance"),
    "mpm": ("interpolation", "transfer", "cure", "seeding", "cfl"),
}
"""Name of a method: options of its solver that a run may give."""

"""The methods that a bar or strip is pulled with until it necks, by name."""

import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from core_models.equilibrium.order import newton_orders
from core_models.erosion.delete import DeletePoint
from core_models.errors import RunFailure, SceneError
from core_models.loads import Load, Prescribed, Symmetry
from core_models.material import Material
from meshes.mesh import Mesh
from meshes.necking_bar import necking_bar
from meshes.tension_strip import tension_strip
from studies.bar_necking import NeckingHistory, NeckingWatch
from studies.material_finder import with_update
from studies.necking.scene import STRIP, NeckingScene, PlannedRun
from studies.quasi_static import KineticWatch, slow_enough

DELETE = "delete"
ROWS = 140  # of the history of an explicit run
START = 0.05  # share of the duration in which an explicit run speeds up
ELASTIC = 0.15  # share after which the body has taken up much more than its elastic start


@dataclass(frozen=True)
class NeckingRun:
    """A run: its history, its final shape and what it cost.

    shape : domains (n, 4, 2) [m] of the points, and strains (n,) their plastic strains. increments, cuts, iterations,
    orders: of Newton's method; steps: explicit. kinetic_share: largest share of kinetic energy, 0 for a static run.
    seconds: of processor time. stopped: why the run did not come to its end; all else then is up to where it got.
    """

    history: NeckingHistory
    shape: np.ndarray
    strains: np.ndarray
    seconds: float
    steps: int
    kinetic_share: float = 0.0
    iterations: int = 0
    cuts: int = 0
    orders: tuple[float, ...] = ()
    stopped: str = ""

    @property
    def strained_share(self) -> float:
        """Share of the shape's area where the plastic strain is more than half the largest: small in shear bands."""
        x, y = self.shape[..., 0], self.shape[..., 1]
        areas = 0.5 * np.abs((x * np.roll(y, -1, axis=1) - y * np.roll(x, -1, axis=1)).sum(axis=1))
        return float(areas[self.strains > 0.5 * self.strains.max()].sum() / areas.sum())


def make_run(scene: NeckingScene, plan: PlannedRun) -> NeckingRun:
    """One run of a scene, `stopped` where it goes wrong on its way; MatpointError for what cannot be at all."""
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
    taper = scene.taper if plan.taper is None else plan.taper
    duration = scene.duration if plan.duration is None else plan.duration
    scene = replace(scene, material=material, taper=taper, duration=duration)
    return METHODS[plan.method](scene, plan)


def _fem_implicit(scene: NeckingScene, plan: PlannedRun) -> NeckingRun:
    import fem

    return _static(scene, plan, lambda body, **options: fem.ImplicitSolver(body, **options))


def _mpm_implicit(scene: NeckingScene, plan: PlannedRun) -> NeckingRun:
    import mpm

    lines = [np.linspace(0.0, scene.radius, plan.across + 1), _graded(scene.length, plan.along, plan.grading)]
    return _static(scene, plan, lambda body, **options: mpm.ImplicitSolver(body, cell_size=lines, **options))


def _fem_explicit(scene: NeckingScene, plan: PlannedRun) -> NeckingRun:
    import fem

    return _explicit(scene, plan, lambda body, **options: fem.ExplicitSolver(body, **options))


def _total_mpm(scene: NeckingScene, plan: PlannedRun) -> NeckingRun:
    """The grid covers the reference body."""
    import mpm

    # The grid's nodes lie half a cell off the symmetry plane: a row of them has to lie on the end that is pulled.
    size = scene.length / (plan.along + 0.5)
    return _explicit(
        scene,
        plan,
        lambda body, **options: mpm.Solver(body, cell_size=size, configuration="total", **options),
    )


def _updated_mpm(scene: NeckingScene, plan: PlannedRun) -> NeckingRun:
    """The grid covers the body as it is; a neck stretches the particles' domains, so that there are many to a cell."""
    import mpm

    size = scene.length / (plan.along + 0.5)
    return _explicit(scene, plan, lambda body, **options: mpm.Solver(body, cell_size=size, **options), CROWD)


CROWD = 2  # elements that particles are seeded from along the axis of a cell: each holds two


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
    "fem-implicit": ("integration", "cure", "own_share", "tolerance"),
    "fem-explicit": ("integration", "cure", "own_share", "hourglass"),
    "mpm-tl": ("interpolation", "transfer", "cure", "seeding", "cfl"),
    "mpm-implicit": ("interpolation", "cure", "seeding", "ghost", "tolerance"),
    "mpm": ("interpolation", "transfer", "cure", "seeding", "cfl"),
}
"""Name of a method: options of its solver that a run may give."""


def _static(scene: NeckingScene, plan: PlannedRun, make: Callable) -> NeckingRun:
    began = time.process_time()
    solver = make(
        body_of(scene, plan), material=scene.material, loads=loads_of(scene, scene.pull / scene.duration),
        increment=scene.duration / plan.increments, geometry=_geometry(scene), **_options(plan),
    )  # fmt: skip
    watch, stopped = NeckingWatch(solver, scene.body != STRIP), ""
    while solver.time < scene.duration and not stopped:
        try:
            solver.advance(scene.duration)
        except RunFailure as reason:
            if not watch.history.rows:
                raise
            stopped = str(reason)
        else:
            watch.add(solver, float(solver.boundary_force("end")[1]))
    log = solver.log
    return NeckingRun(
        watch.history, *_shape(solver), time.process_time() - began, solver.step_count, 0.0, len(log.iterations),
        len(log.cuts), tuple(newton_orders(log)), stopped,
    )  # fmt: skip


def _explicit(scene: NeckingScene, plan: PlannedRun, make: Callable, crowd: int = 1) -> NeckingRun:
    began = time.process_time()
    start = START * scene.duration
    speed = scene.pull / (scene.duration - 0.5 * start)
    body, material = body_of(scene, plan, crowd), scene.material
    if plan.periods > 0.0:
        material = _slowed(scene, plan.periods)
    loads = loads_of(scene, lambda _places, t: speed * min(t / start, 1.0))
    solver = make(body, material=material, loads=loads, geometry=_geometry(scene), **_options(plan))
    watch, kinetic = NeckingWatch(solver, scene.body != STRIP), KineticWatch(ELASTIC * scene.duration)
    for row in range(ROWS):
        # Elastic waves run through the bar: a row's force is the mean over the time since the row before.
        end, impulse = (row + 1) * scene.duration / ROWS, 0.0
        before = solver.time
        while solver.time < end:
            last = solver.time
            solver.advance(end)
            impulse += float(solver.boundary_force("end")[1]) * (solver.time - last)
        watch.add(solver, impulse / (end - before))
        if not watch.history.rows[-1][NeckingHistory.COLUMNS.index("failed")]:
            kinetic.look(solver)
    if plan.periods > 0.0:
        kinetic.check()
    seconds = time.process_time() - began
    return NeckingRun(watch.history, *_shape(solver), seconds, solver.step_count, kinetic.share)


def _slowed(scene: NeckingScene, periods: float) -> Material:
    """The material with its mass scaled by the lowest mode, which a coarse mesh has as well as a fine one."""
    coarse = body_of(scene, PlannedRun("", "", 3, 12))
    loads = loads_of(scene, 0.0)
    return slow_enough(coarse, scene.material, loads, scene.duration, periods, _geometry(scene))


def _shape(solver) -> tuple[np.ndarray, np.ndarray]:
    return solver.domains(), solver.points.old.equivalent_plastic_strain.copy()


def _options(plan: PlannedRun) -> dict[str, Any]:
    return {**plan.options, "conduction": True} if plan.conduction else dict(plan.options)


def _geometry(scene: NeckingScene) -> str:
    return "plane-strain" if scene.body == STRIP else "axisymmetric"


def loads_of(scene: NeckingScene, velocity: Any) -> tuple[Load, ...]:
    """Supports of the half, or quarter, whose end moves with a velocity [m/s]."""
    loads = (Symmetry("neck"), Prescribed("end", 1, velocity))
    if scene.body == STRIP:
        loads = (Symmetry("symmetry"), *loads)
    return (*loads, Prescribed("end", 0, 0.0)) if scene.held else loads


def body_of(scene: NeckingScene, plan: PlannedRun, crowd: int = 1) -> Mesh:
    """The mesh of a run, with so many elements along for each that was asked for."""
    across, along = plan.across, plan.along * crowd
    if scene.body == STRIP:
        return tension_strip(scene.radius, scene.length, across, along, scene.taper, plan.kind)
    return necking_bar(scene.radius, scene.length, across, along, scene.taper, plan.grading, plan.kind)


def _graded(length: float, count: int, grading: float) -> np.ndarray:
    """Lines between cells along the axis [m], the first `grading` times as long as the last."""
    sizes = grading ** -(np.arange(count) / max(count - 1, 1))
    return np.concatenate([[0.0], length * np.cumsum(sizes) / sizes.sum()])

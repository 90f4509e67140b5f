"""The methods that a bar is pulled with until it necks, by name."""

import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from core_models.equilibrium.order import newton_orders
from core_models.loads import Load, Prescribed, Symmetry
from meshes.mesh import Mesh
from meshes.necking_bar import necking_bar
from studies.bar_necking import NeckingHistory, NeckingScene
from studies.quasi_static import KineticWatch, slow_enough

ROWS = 140  # of the history of an explicit run
START = 0.05  # share of the duration in which an explicit run speeds up
ELASTIC = 0.15  # share after which the body has taken up much more than its elastic start


@dataclass(frozen=True)
class NeckingMesh:
    """Elements across the radius and along the half bar, and size at the neck over that at the end."""

    across: int
    along: int
    grading: float = 1.0

    @property
    def label(self) -> str:
        """across x along, and the grading where there is one."""
        return f"{self.across} × {self.along}" + ("" if self.grading == 1.0 else f" graded {self.grading:g}")


@dataclass(frozen=True)
class NeckingRun:
    """A run: its history and what it cost. increments, cuts, iterations, orders: of Newton's method; steps: explicit.

    kinetic_share: largest share of kinetic energy, 0 for a static run. seconds: of processor time.
    """

    method: str
    mesh: NeckingMesh
    history: NeckingHistory
    seconds: float
    steps: int
    kinetic_share: float = 0.0
    iterations: int = 0
    cuts: int = 0
    orders: tuple[float, ...] = ()

    @property
    def label(self) -> str:
        """Method, mesh and, of an implicit run, its increments."""
        return f"{self.method}, {self.mesh.label}" + (f", {self.steps} increments" if self.iterations else "")


def implicit_run(
    scene: NeckingScene,
    mesh: NeckingMesh,
    increments: int,
    name: str = "fem-implicit",
    kind: str = "quad4",
    **options,
) -> NeckingRun:
    """Implicit finite elements in so many increments; options: of `fem.ImplicitSolver`."""
    import fem

    began = time.process_time()
    loads = _loads(scene.pull / scene.duration)
    step = scene.duration / increments
    solver = fem.ImplicitSolver(
        _body(scene, mesh, kind), scene.material, loads=loads, increment=step, **options
    )
    history = NeckingHistory(solver)
    while solver.time < scene.duration:
        solver.advance(scene.duration)
        history.add(solver, float(solver.boundary_force("end")[1]))
    log = solver.log
    return NeckingRun(
        name, mesh, history, time.process_time() - began, solver.step_count, 0.0, len(log.iterations), len(log.cuts),
        tuple(newton_orders(log)),
    )  # fmt: skip


def explicit_fem_run(scene: NeckingScene, mesh: NeckingMesh, periods: float) -> NeckingRun:
    """Explicit finite elements, loaded over so many periods of the lowest natural mode."""
    import fem

    def make(body: Mesh, material, loads: tuple[Load, ...]):
        return fem.ExplicitSolver(body, material, loads=loads)

    return _explicit_run(scene, mesh, periods, "fem-explicit", make)


def total_mpm_run(scene: NeckingScene, mesh: NeckingMesh, periods: float, **options: Any) -> NeckingRun:
    """Material point method with the grid over the reference body, loaded as slowly."""
    import mpm

    def make(body: Mesh, material, loads: tuple[Load, ...]):
        # The grid's nodes lie half a cell off the symmetry plane: a row of them has to lie on the end that is pulled.
        size = scene.length / (mesh.along + 0.5)
        return mpm.Solver(body, material, cell_size=size, loads=loads, configuration="total", **options)

    return _explicit_run(scene, mesh, periods, "mpm-tl", make)


def _explicit_run(
    scene: NeckingScene, mesh: NeckingMesh, periods: float, name: str, make: Callable
) -> NeckingRun:
    began = time.process_time()
    start = START * scene.duration
    speed = scene.pull / (scene.duration - 0.5 * start)
    loads = _loads(lambda _places, t: speed * min(t / start, 1.0))
    body = _body(scene, mesh, "quad4")
    material = slow_enough(body, scene.material, _loads(0.0), scene.duration, periods)
    solver = make(body, material, loads)
    history, watch = NeckingHistory(solver), KineticWatch(ELASTIC * scene.duration)
    for row in range(ROWS):
        # Elastic waves run through the bar: a row's force is the mean over the time since the row before.
        end, impulse = (row + 1) * scene.duration / ROWS, 0.0
        before = solver.time
        while solver.time < end:
            last = solver.time
            solver.advance(end)
            impulse += float(solver.boundary_force("end")[1]) * (solver.time - last)
        history.add(solver, impulse / (end - before))
        watch.look(solver)
    watch.check()
    seconds = time.process_time() - began
    return NeckingRun(name, mesh, history, seconds, solver.step_count, watch.share)


def _loads(velocity: Any) -> tuple[Load, ...]:
    return Symmetry("neck"), Prescribed("end", 1, velocity)


def _body(scene: NeckingScene, mesh: NeckingMesh, kind: str) -> Mesh:
    return necking_bar(scene.radius, scene.length, mesh.across, mesh.along, scene.taper, mesh.grading, kind)

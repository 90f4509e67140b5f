"""Bodies driven slowly by prescribed motion: elements and material points, implicit and explicit."""

import time
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from core_models.loads import Load
from core_models.material import Material
from meshes.mesh import Mesh
from studies.methods.quasi_static import KineticWatch, slow_enough

START = 0.1  # share of the duration in which an explicit run speeds up, unless given
ELASTIC = 0.2  # share after which the body has taken up much more than its elastic start
IMPLICIT, EXPLICIT, POINTS, IMPLICIT_POINTS = "fem-implicit", "fem-explicit", "mpm-tl", "mpm-implicit"
METHODS = (IMPLICIT, EXPLICIT, POINTS, IMPLICIT_POINTS)
STATIC = (IMPLICIT, IMPLICIT_POINTS)

Pace = Callable[[float], float]
"""Share of the prescribed velocities at a time [s]."""


@dataclass(frozen=True)
class Body:
    """A body and how it is driven.

    mesh, material, geometry : as the solvers take them. loads : all loads, from the pace that multiplies prescribed
    velocities. duration : of the loading [s]. rows : of the record, and implicit increments. cell_size : of the grid
    of material points [m]. periods : of the lowest natural mode that an explicit run takes. start : share of the
    duration in which it speeds up.
    """

    mesh: Mesh
    material: Material
    geometry: str
    loads: Callable[[Pace], tuple[Load, ...]]
    duration: float
    rows: int
    cell_size: float
    periods: float = 100.0
    start: float = START


@dataclass(frozen=True)
class Record:
    """What was read after every row: values (rows, columns). seconds : of processor time. steps : that were made.

    kinetic_share : largest share of kinetic energy in what the body has taken up, 0 of a static run. solver : at the
    end.
    """

    method: str
    values: np.ndarray
    seconds: float
    steps: int
    kinetic_share: float
    solver: object


class Reading:
    """Means over a row: work done from outside [J] and the reaction of a boundary (d,) [N]."""

    def __init__(self, boundary: str) -> None:
        self._boundary = boundary

    def row(self, solver, end: float) -> tuple[float, np.ndarray]:
        """Step to `end` [s]; work within the row, and the reaction: at the end of an implicit run, else the mean."""
        before, began = solver.ledger.external, solver.time
        impulse = np.zeros(solver.mesh.dimension)
        while solver.time < end:
            last = solver.time
            solver.advance(end)
            impulse += (solver.time - last) * solver.boundary_force(self._boundary)
        if solver.method in STATIC:
            return solver.ledger.external - before, solver.boundary_force(self._boundary)
        return solver.ledger.external - before, impulse / (end - began)


def record(method: str, body: Body, boundary: str, read: Callable) -> Record:
    """Drive the body by a method of `METHODS`; read(solver, work [J], reaction (d,) [N]) gives a row's values.

    Raises RunFailure for an explicit run that moved too fast to be called quasi-static.
    """
    began = time.process_time()
    solver = _solver(method, body)
    reading, watch = Reading(boundary), KineticWatch(ELASTIC * body.duration)
    values = []
    for i in range(body.rows):
        values.append(read(solver, *reading.row(solver, (i + 1) * body.duration / body.rows)))
        watch.look(solver)
    watch.check()
    seconds = time.process_time() - began
    return Record(method, np.array(values), seconds, solver.step_count, watch.share, solver)


def _solver(method: str, body: Body):
    import fem
    import mpm

    step, start = body.duration / body.rows, body.start * body.duration
    if method in STATIC:
        static = {"geometry": body.geometry, "loads": body.loads(lambda t: 1.0), "increment": step}
        if method == IMPLICIT:
            return fem.ImplicitSolver(body.mesh, body.material, **static)
        return mpm.ImplicitSolver(body.mesh, body.material, cell_size=body.cell_size, **static)
    held = body.loads(lambda t: 0.0)
    material = slow_enough(body.mesh, body.material, held, body.duration, body.periods, body.geometry)
    loads = body.loads(lambda t: min(t / start, 1.0))
    if method == EXPLICIT:
        return fem.ExplicitSolver(body.mesh, material, geometry=body.geometry, loads=loads)
    return mpm.Solver(
        body.mesh,
        material,
        geometry=body.geometry,
        loads=loads,
        cell_size=body.cell_size,
        configuration="total",
    )

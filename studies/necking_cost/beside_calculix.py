"""The necking bar by implicit elements and by CalculiX on the same mesh: processor time and answers."""

import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

import numpy as np

import fem
from core_models.errors import UnsupportedError
from core_models.loads import Prescribed, Symmetry
from meshes.mesh import Mesh
from meshes.necking_bar import necking_bar
from studies.necking.reader import read_necking_scene
from studies.necking.scene import NeckingScene
from studies.necking_cost.calculix import run_calculix
from studies.report.parts import Table
from studies.verification.outcome import Criterion, Outcome
from studies.verification.problem import Problem

MESHES = {False: (10, 40), True: (5, 20)}  # elements across and along; with --quick
GRADING = 0.05
COARSE, FINE = 50, 250  # increments
AT = 5e-3  # elongation at which answers are compared [m]
WEDGES = 180.0  # of 2 degrees, which CalculiX takes for a body of revolution


@dataclass(frozen=True)
class Answer:
    """Peak and force at AT [N], radius of the neck there [m], increments, seconds of processor time."""

    peak: float
    force: float
    neck: float
    increments: int
    seconds: float


def ours(scene: NeckingScene, mesh: Mesh, increments: int, **options) -> Answer:
    """By `fem.ImplicitSolver`, compiled beforehand."""
    _pulled(scene, mesh, increments, 2, **options)
    began = time.process_time()
    rows = _pulled(scene, mesh, increments, increments, **options)
    return _answer(*rows, time.process_time() - began)


def _pulled(scene: NeckingScene, mesh: Mesh, increments: int, count: int, **options) -> np.ndarray:
    loads = (Symmetry("neck"), Prescribed("end", 1, scene.pull))
    solver = fem.ImplicitSolver(mesh, scene.material, loads=loads, increment=1.0 / increments, **options)
    rows = []
    while solver.time < count / increments:
        solver.advance(count / increments)
        neck = solver.boundary_positions("neck")[:, 0].max()
        rows.append((scene.pull * solver.time, solver.boundary_force("end")[1], neck))
    return np.array(rows).T


def theirs(scene: NeckingScene, mesh: Mesh, increments: int) -> Answer:
    """By CalculiX; UnsupportedError where it is not installed."""
    with tempfile.TemporaryDirectory() as folder:
        run = run_calculix(Path(folder), scene, mesh, increments)
    return _answer(run.elongation, WEDGES * run.force, run.neck_radius, run.seconds)


def _answer(elongation: np.ndarray, force: np.ndarray, neck: np.ndarray, seconds: float) -> Answer:
    at_5, neck_5 = (float(np.interp(AT, elongation, values)) for values in (force, neck))
    return Answer(float(force.max()), at_5, neck_5, len(force), seconds)


def run(quick: bool) -> Outcome:
    """Same mesh with as many increments, and as accurate an answer."""
    scene, counts = read_necking_scene("necking-simo"), MESHES[quick]
    square, quadratic = (
        necking_bar(scene.radius, scene.length, *counts, scene.taper, GRADING, kind)
        for kind in ("quad4", "quad8")
    )
    try:
        other = theirs(scene, quadratic, COARSE)
    except UnsupportedError as reason:
        return Outcome(criteria=[Criterion("time of CalculiX over ours", None, low=1.0, reason=str(reason))])
    rows = {
        "CalculiX, CAX8R": other,
        "quad8, reduced integration": ours(scene, quadratic, other.increments, integration="reduced"),
        "quad8, reduced integration, fine": ours(scene, quadratic, FINE, integration="reduced"),
        "quad4, fine": ours(scene, square, FINE),
    }
    outcome = Outcome()
    for name in list(rows)[1:]:
        what = f"processor time of CalculiX over that of {name}"
        outcome.criteria.append(Criterion(what, other.seconds / rows[name].seconds, low=1.0))
    head = (
        "run",
        "increments",
        "time [s]",
        "CalculiX over it",
        "peak [kN]",
        "force at 5 mm [kN]",
        "neck at 5 mm [mm]",
    )
    cells = tuple(
        (
            name, each.increments, round(each.seconds, 2), round(other.seconds / each.seconds, 2),
            round(1e-3 * each.peak, 2), round(1e-3 * each.force, 2), round(1e3 * each.neck, 3),
        )
        for name, each in rows.items()
    )  # fmt: skip
    note = f"Mesh {counts[0]} × {counts[1]} graded {GRADING:g}; processor time on one thread, nothing compiled in it."
    outcome.tables.append(Table("Beside CalculiX", head, cells, note))
    return outcome


PROBLEM = Problem(
    "calculix",
    "Necking beside CalculiX",
    "The necking bar of Simo by implicit elements and by CalculiX with second-order elements of reduced integration on "
    "the same mesh, with as many increments, and with as many as the answer takes to be as accurate.",
    "Dhondt, The Finite Element Method for Three-Dimensional Thermomechanical Applications (2004)",
    run,
)

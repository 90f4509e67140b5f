"""Time and memory of an implicit increment against the number of degrees of freedom, by linear solver."""

import multiprocessing
import resource
import time
from importlib.util import find_spec

import fem
from core_models.loads import Prescribed, Symmetry
from meshes.necking_bar import necking_bar
from studies.necking.reader import read_necking_scene
from studies.report.parts import Curve, Plot, Table
from studies.verification.outcome import Criterion, Outcome
from studies.verification.problem import Problem

ALONG = 4  # elements along for one across
GRADING = 0.2
MODULES = {"scipy": "scipy", "pardiso": "pypardiso", "petsc": "petsc4py"}
MESHES = {"scipy": (3, 6, 9, 12), "pardiso": (3, 6, 12, 22), "petsc": (3, 6, 12)}  # elements across
FIRST = 0.02  # of the pull: all of the bar flows
BIG, GIGABYTES = 100_000, 4.0
GIBI = 1024.0**2  # kB


def measured(solver: str, across: int) -> tuple[int, float, float]:
    """Degrees of freedom, processor time of an iteration [s] and the process's largest memory [GiB], of hex8."""
    scene = read_necking_scene("necking-simo")
    mesh = necking_bar(scene.radius, scene.length, across, ALONG * across, scene.taper, GRADING, "hex8")
    loads = (
        Symmetry("neck"), Symmetry("symmetry_x"), Symmetry("symmetry_y"), Prescribed("end", 2, scene.pull)
    )  # fmt: skip
    body = fem.ImplicitSolver(mesh, scene.material, loads=loads, increment=FIRST, linear_solver=solver)
    body.advance()
    count, began = len(body.log.iterations), time.process_time()
    body.advance()
    seconds = (time.process_time() - began) / (len(body.log.iterations) - count)
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / GIBI
    return body.log.records[0].dofs, seconds, memory


def run(quick: bool) -> Outcome:
    """Every solver that is installed; each mesh in a process of its own, whose memory it is."""
    outcome, rows, curves = Outcome(), [], []
    processes = multiprocessing.get_context("spawn")
    for solver, meshes in MESHES.items():
        if find_spec(MODULES[solver]) is None:
            outcome.remarks.append(f"{solver} is not installed.")
            continue
        found = []
        for across in meshes[: 2 if quick else None]:
            with processes.Pool(1) as pool:
                found.append(pool.apply(measured, (solver, across)))
            rows.append((solver, *(round(each, 3) for each in found[-1])))
        dofs, seconds, memory = zip(*found, strict=True)
        curves.append(Curve(solver, dofs, seconds, "fem"))
        if dofs[-1] >= BIG:
            what = f"memory of {dofs[-1]} degrees of freedom by {solver}"
            outcome.criteria.append(Criterion(what, memory[-1], high=GIGABYTES, unit="GiB"))
    head = ("linear solver", "degrees of freedom", "time of an iteration [s]", "largest memory [GiB]")
    note = "Eighth of the bar, hex8 with mean dilatation; processor time of all threads, while all of the bar flows."
    outcome.tables.append(Table("Cost of an iteration", head, tuple(rows), note))
    outcome.plots.append(
        Plot(
            "Cost of an iteration",
            "degrees of freedom",
            "processor time [s]",
            tuple(curves),
            logarithmic=True,
        )
    )
    return outcome


PROBLEM = Problem(
    "dofs",
    "Time against degrees of freedom",
    "One iteration of Newton's method on an eighth of the necking bar, in three dimensions, by each linear solver that "
    "is installed.",
    "",
    run,
)

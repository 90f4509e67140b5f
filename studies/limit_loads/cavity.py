"""Thick walls that a growing cavity brings to flow: what the cylinder and the sphere share."""

import math

import numpy as np

from core_models.loads import Load, Prescribed, Symmetry
from core_models.material import Material
from meshes.annulus import annulus
from meshes.block import block
from meshes.mesh import Mesh
from studies.limit_loads.closed_forms import SPHERE, cavity_pressure
from studies.limit_loads.loading import IMPLICIT, METHODS, Body, Pace, Record, record
from studies.limit_loads.materials import COHESION
from studies.report.parts import FEM, MPM, Curve, Plot, Table
from studies.verification.outcome import Criterion, Outcome

INNER, OUTER = 1.0, 2.0  # m
GROWTH = 0.002  # m, of the inner radius
DURATION, ROWS = 1.0, 40  # s, of the loading
LAST = 8  # rows over which the limit is averaged
CELLS = {False: 16, True: 8}  # across the wall
TOLERANCE = {IMPLICIT: 0.005}  # relative; of the others 1 %
COARSEST = 0.01

Case = tuple[Material, float, float]
"""Material, and the cohesion [Pa] and friction [degree] of the Mohr-Coulomb wall that has the same limit."""


def wall(around: int, cells: int) -> Mesh:
    """A slice of the cylinder, or a quarter of the sphere's section, with `inner` and `outer` among its boundaries."""
    if around == SPHERE:
        # Twice as many around, so that the grid of material points does not see between the faces that are moved.
        return annulus(INNER, OUTER, [cells, 2 * cells], "quad4", quarter=True)
    mesh = block([INNER, 0.0], [OUTER, 2.0 * _cell_size(cells)], [cells, 2], "quad4")
    names = {"left": "inner", "right": "outer"}
    boundaries = {names.get(name, name): facets for name, facets in mesh.boundaries.items()}
    return Mesh(mesh.points, mesh.kind, mesh.cells, boundaries)


def body(around: int, material: Material, cells: int) -> Body:
    """The wall whose inner surface is moved outwards."""
    speed = GROWTH / DURATION

    def loads(pace: Pace) -> tuple[Load, ...]:
        outwards = [
            Prescribed("inner", axis, lambda X, t, axis=axis: pace(t) * speed * X[:, axis] / INNER)
            for axis in range(around)
        ]
        planes = ("symmetry_y",) if around == SPHERE else ("bottom", "top")
        return (*outwards, *(Symmetry(name) for name in planes))

    return Body(wall(around, cells), material, "axisymmetric", loads, DURATION, ROWS, _cell_size(cells))


def _cell_size(cells: int) -> float:
    return (OUTER - INNER) / cells


def pressures(method: str, around: int, case: Case, cells: int) -> Record:
    """Rows of inner radius [m], pressure within the row by its work, and its limit for the present radii [Pa]."""
    material, cohesion, friction = case
    place = {"inner": INNER}

    def read(solver, work: float, _reaction: np.ndarray) -> tuple[float, float, float]:
        inner, outer = (_radius(solver, name) for name in ("inner", "outer"))
        swept = _volume(around, inner, solver) - _volume(around, place["inner"], solver)
        place["inner"] = inner
        return inner, work / swept, cavity_pressure(cohesion, friction, inner, outer, around)

    return record(method, body(around, material, cells), "inner", read)


def _radius(solver, name: str) -> float:
    return float(np.linalg.norm(solver.boundary_positions(name) * _shape(solver), axis=1).mean())


def _shape(solver) -> np.ndarray:
    return np.array([1.0, float("symmetry_y" in solver.mesh.boundaries)])


def _volume(around: int, inner: float, solver) -> float:
    if around == SPHERE:
        return 2.0 / 3.0 * math.pi * inner**3
    return math.pi * inner**2 * float(np.ptp(solver.mesh.points[:, 1]))


def limit(found: Record) -> float:
    """Mean pressure over that of the closed form at the same radii, in the last rows."""
    return float((found.values[-LAST:, 1] / found.values[-LAST:, 2]).mean())


def outcome(around: int, cases: dict[str, Case], quick: bool, methods: tuple[str, ...] = METHODS) -> Outcome:
    """Every condition by every method."""
    result, rows = Outcome(), []
    for name, case in cases.items():
        found = [pressures(method, around, case, CELLS[quick]) for method in methods]
        exact = cavity_pressure(*case[1:], INNER, OUTER, around)
        for each in found:
            off = 100.0 * (limit(each) - 1.0)
            allowed = 100.0 * TOLERANCE.get(each.method, COARSEST)
            what = f"limit pressure, {name}, {each.method}, off the closed form by"
            result.criteria.append(Criterion(what, off, -allowed, allowed, "%"))
            rows.append(
                (f"{name}, {each.method}", exact / COHESION, (1.0 + 0.01 * off) * exact / COHESION, off,
                 each.steps, 100.0 * each.kinetic_share, each.seconds)
            )  # fmt: skip
        result.plots.append(plot(name, found))
    head = ("run", "p / c", "found", "off by [%]", "steps", "kinetic share [%]", "processor s")
    note = (
        f"{CELLS[quick]} cells across the wall, b / a = {OUTER / INNER:g}. The closed form is taken at the radii that "
        f"the wall has by then; over the last {LAST} of {ROWS} rows. Of the first run of a condition the processor "
        "time holds compilation where there was any."
    )
    result.tables.append(Table("Limit pressure", head, tuple(rows), note))
    return result


def plot(name: str, found: list[Record]) -> Plot:
    """Pressure over the inner radius, all methods and the closed form."""
    best, grown = found[0].values, [tuple(1e3 * (each.values[:, 0] - INNER)) for each in found]
    curves = [Curve("limit", grown[0], tuple(best[:, 2] / COHESION), "exact")]
    curves += [
        Curve(each.method, way, tuple(each.values[:, 1] / COHESION), MPM if each.method.startswith("mpm") else FEM)
        for each, way in zip(found, grown, strict=True)
    ]  # fmt: skip
    return Plot(name, "growth of the inner radius [mm]", "pressure / cohesion", tuple(curves))

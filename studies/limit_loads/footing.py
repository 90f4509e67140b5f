"""A rough strip footing on weightless ground, against Prandtl's bearing capacity."""

import numpy as np

from core_models.loads import Fixed, Load, Prescribed, Symmetry
from core_models.material import Material
from meshes.block import block
from meshes.mesh import Mesh
from studies.limit_loads.closed_forms import bearing_factor
from studies.limit_loads.loading import (
    EXPLICIT,
    IMPLICIT,
    IMPLICIT_POINTS,
    POINTS,
    Body,
    Pace,
    Record,
    record,
)
from studies.limit_loads.materials import COHESION, drucker_prager, mohr_coulomb, tresca, von_mises
from studies.report.parts import FEM, MPM, Curve, Picture, Plot, Table
from studies.verification.outcome import Criterion, Outcome
from studies.verification.problem import Problem

HALF = 0.5  # m, half the footing's width
FRICTION = 20.0  # degree
WIDTH, DEPTH = {0.0: 3.0, FRICTION: 4.0}, 2.0  # m, of half the ground: Prandtl's wedge ends inside
SETTLEMENT = {0.0: 0.002, FRICTION: 0.006}  # m, at which the load no longer grows by more than 1 %
ROWS, PERIODS = 16, 30.0
TOLERANCE = {
    0.0: 3.0,
    FRICTION: 5.0,
}  # %: friction sharpens the singular edge, and the limit falls more slowly

CASES: dict[str, tuple[Material, float]] = {
    "Tresca": (tresca(COHESION), 0.0),
    "von Mises": (von_mises(COHESION), 0.0),
    "Mohr-Coulomb": (mohr_coulomb(FRICTION), FRICTION),
    "Drucker-Prager": (drucker_prager(FRICTION, "plane-strain"), FRICTION),
}
CELLS = {
    False: {IMPLICIT: (4, 8, 16), EXPLICIT: (4, 8), POINTS: (4, 8), IMPLICIT_POINTS: (4, 8)},
    True: {IMPLICIT: (4, 8)},
}
"""Cells under half the footing, by method."""
EVERYWHERE = ("Tresca", "Mohr-Coulomb")  # what explicit elements and material points run


def ground(width: float, size: float) -> Mesh:
    """Half of the ground in square cells of a size [m] that divides the footing; `footing` is the top's loaded part."""
    mesh = block([0.0, -DEPTH], [width, 0.0], [round(width / size), round(DEPTH / size)], "quad4")
    top = mesh.boundaries["top"]
    loaded = mesh.points[top][:, :, 0].max(axis=1) < HALF + 1e-9
    return Mesh(mesh.points, mesh.kind, mesh.cells, mesh.boundaries | {"footing": top[loaded]})


def body(material: Material, friction: float, cells: int) -> Body:
    """The ground whose footing is pressed in and does not slide; angle of friction [degree]."""
    settlement = SETTLEMENT[friction]

    def loads(pace: Pace) -> tuple[Load, ...]:
        return (
            Prescribed("footing", 0),
            Prescribed("footing", 1, lambda X, t: -pace(t) * settlement),
            Symmetry("left"),
            Prescribed("right", 0),
            Fixed("bottom"),
        )

    size = HALF / cells
    return Body(ground(WIDTH[friction], size), material, "plane-strain", loads, 1.0, ROWS, size, PERIODS)


def pressed(method: str, name: str, cells: int) -> Record:
    """Rows of settlement [m] and pressure under the footing over the cohesion."""
    material, friction = CASES[name]

    def read(solver, _work: float, reaction: np.ndarray) -> tuple[float, float]:
        return solver.time * SETTLEMENT[friction], -reaction[1] / (HALF * COHESION)

    return record(method, body(material, friction, cells), "footing", read)


def extrapolated(found: list[Record], cells: tuple[int, ...]) -> float:
    """Limit over the cohesion for cells of size 0: an error in proportion to it, through the two finest."""
    (one, two), (few, many) = (each.values[-1, 1] for each in found[-2:]), cells[-2:]
    return float((many * two - few * one) / (many - few))


def run(quick: bool) -> Outcome:
    """Four conditions by implicit elements, two of them by all methods."""
    outcome, rows, finest = Outcome(), [], {}
    for name, (_material, friction) in CASES.items():
        exact, shown = bearing_factor(friction), []
        for method, cells in CELLS[quick].items():
            if method != IMPLICIT and name not in EVERYWHERE:
                continue
            found = [pressed(method, name, count) for count in cells]
            value = extrapolated(found, cells)
            off = 100.0 * (value / exact - 1.0)
            what = f"N_c, {name}, {method}, for cells of size 0, off the closed form by"
            outcome.criteria.append(Criterion(what, off, -TOLERANCE[friction], TOLERANCE[friction], "%"))
            rows += [
                (
                    f"{name}, {method}, {count}",
                    exact,
                    each.values[-1, 1],
                    None,
                    None,
                    each.steps,
                    each.seconds,
                )
                for count, each in zip(cells, found, strict=True)
            ]
            rows[-1] = (*rows[-1][:3], value, off, *rows[-1][5:])
            shown.append(found[-1])
            finest[f"{name}, {method}"] = found[-1].solver
        outcome.plots.append(_plot(name, exact, shown))
    head = ("condition, method, cells", "N_c", "found", "for size 0", "off by [%]", "steps", "processor s")
    outcome.tables.append(Table("Pressure under the footing over the cohesion", head, tuple(rows), _note()))
    outcome.pictures.append(_mechanism({each: finest[each] for each in finest if "Mohr" in each}))
    return outcome


def _note() -> str:
    return (
        "Cells are counted under half the footing. The velocity jumps at the footing's edge, which cells of size h "
        "smear over h: the limit grows in proportion to it, hence the extrapolation through the two finest. Of the "
        "first run of a condition the processor time holds compilation where there was any."
    )


def _plot(name: str, exact: float, found: list[Record]) -> Plot:
    end = 1e3 * found[0].values[-1, 0]
    curves = [Curve("limit", (0.0, end), (exact, exact), "exact")]
    curves += [
        Curve(each.method, tuple(1e3 * each.values[:, 0]), tuple(each.values[:, 1]),
              MPM if each.method.startswith("mpm") else FEM)
        for each in found
    ]  # fmt: skip
    return Plot(f"{name}, finest cells", "settlement [mm]", "pressure / cohesion", tuple(curves))


def _mechanism(solvers: dict) -> Picture:
    fields = {
        name: (solver.domains(), solver.points.old.equivalent_plastic_strain.copy())
        for name, solver in solvers.items()
    }
    return Picture("Prandtl's wedge", "plastic strain", fields, (0.0, 0.015))


PROBLEM = Problem(
    "footing",
    "Strip footing",
    "A rigid rough footing, 1 m wide, is pressed into weightless ground in plane strain, without friction and with an "
    "angle of 20 degrees, flow being associated. The pressure that it takes over the cohesion, N_c, against Prandtl's.",
    "Prandtl, Nachr. Ges. Wiss. Göttingen (1920) 74",
    run,
)

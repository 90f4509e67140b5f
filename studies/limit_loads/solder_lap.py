"""A soldered lap joint that is sheared at several rates and temperatures, against the law alone."""

from dataclasses import dataclass, replace

import numpy as np

from core_models.cards import read_material, shipped_materials
from core_models.driver import drive, isothermal
from core_models.loads import Fixed, Load, Prescribed
from core_models.material import Material
from meshes.block import block
from studies.limit_loads.loading import IMPLICIT, METHODS, Body, Pace, Record, record
from studies.report.parts import FEM, MPM, Curve, Plot, Table
from studies.verification.outcome import Criterion, Outcome
from studies.verification.problem import Problem

LENGTH, THICKNESS = 2e-3, 0.1e-3  # m
SHEAR = 0.1  # of the joint, at the end
ROWS = 25
CELLS = {False: 4, True: 3}  # through the thickness
TOLERANCE = 3.0  # %


@dataclass(frozen=True)
class Test:
    """A shear test: rate [1/s], temperature [K], methods that run it."""

    rate: float
    temperature: float
    methods: tuple[str, ...] = (IMPLICIT,)

    @property
    def label(self) -> str:
        """Rate and temperature."""
        return f"{self.rate:g} /s, {self.temperature:g} K"


TESTS = (Test(1e-2, 298.0, METHODS), Test(1e-4, 298.0), Test(1e-2, 373.0))


def solder(temperature: float) -> Material:
    """The shipped tin-lead solder at a constant temperature [K]."""
    card = read_material(shipped_materials()["solder_60sn40pb_anand"]).material
    return replace(isothermal(card), room_temperature=temperature)


def body(test: Test, cells: int) -> Body:
    """The layer of solder between stiff arms, of which the upper one moves along it; its ends are free."""
    speed = test.rate * THICKNESS
    mesh = block([0.0, 0.0], [LENGTH, THICKNESS], [round(cells * LENGTH / THICKNESS), cells], "quad4")

    def loads(pace: Pace) -> tuple[Load, ...]:
        return Fixed("bottom"), Prescribed("top", 0, lambda X, t: pace(t) * speed), Prescribed("top", 1)

    size = THICKNESS / cells
    return Body(
        mesh, solder(test.temperature), "plane-strain", loads, SHEAR / test.rate, ROWS, size, periods=120.0
    )


def sheared(method: str, test: Test, cells: int) -> Record:
    """Rows of time [s], shear and mean shear stress [Pa]."""

    def read(solver, _work: float, reaction: np.ndarray) -> tuple[float, float, float]:
        way = solver.boundary_positions("top")[:, 0].mean() - 0.5 * LENGTH
        return solver.time, way / THICKNESS, reaction[0] / LENGTH

    return record(method, body(test, cells), "top", read)


def slab(test: Test) -> tuple[np.ndarray, np.ndarray]:
    """Shear and shear stress [Pa] of a point in simple shear: the joint without ends."""
    shear = np.linspace(0.0, SHEAR, 4 * ROWS + 1)
    path = np.tile(np.eye(3), (len(shear), 1, 1))
    path[:, 0, 1] = shear
    history = drive(solder(test.temperature), path, SHEAR / test.rate / (len(shear) - 1))
    return shear, history.stress[:, 3]


def run(quick: bool) -> Outcome:
    """Three tests by implicit elements, one of them by all methods."""
    outcome, rows, curves = Outcome(), [], []
    for test in TESTS:
        shear, stress = slab(test)
        curves.append(Curve(f"slab, {test.label}", tuple(100.0 * shear), tuple(1e-6 * stress), "exact"))
        for method in test.methods[: 1 if quick else None]:
            found = sheared(method, test, CELLS[quick])
            _time, last, value = found.values[-1]
            exact = float(np.interp(last, shear, stress))
            off = 100.0 * (value / exact - 1.0)
            what = f"shear force, {test.label}, {method}, off the slab's by"
            outcome.criteria.append(Criterion(what, off, -TOLERANCE, TOLERANCE, "%"))
            rows.append(
                (f"{test.label}, {method}", 1e-6 * value, 1e-6 * exact, off, found.steps, found.seconds)
            )
            curves.append(
                Curve(f"{method}, {test.label}", tuple(100.0 * found.values[:, 1]),
                      tuple(1e-6 * found.values[:, 2]), MPM if method.startswith("mpm") else FEM)
            )  # fmt: skip
    head = ("test, method", "mean shear stress [MPa]", "slab [MPa]", "off by [%]", "steps", "processor s")
    note = (
        f"At a shear of {SHEAR:g}; the joint is {LENGTH / THICKNESS:g} times as long as thick, {CELLS[quick]} cells "
        "thick, and its ends are free of stress, which the slab does not know of. Of the first run of a method the "
        "processor time holds compilation where there was any."
    )
    outcome.tables.append(Table("Shear of the joint", head, tuple(rows), note))
    outcome.plots.append(Plot("Sheared joint", "shear [%]", "mean shear stress [MPa]", tuple(curves)))
    return outcome


PROBLEM = Problem(
    "solder-lap",
    "Soldered lap joint",
    "A layer of tin-lead solder between stiff arms is sheared, plane strain, at two rates and two temperatures. Its "
    "force over its area against the stress of the Anand law alone in simple shear.",
    "Wang, Cheng, Becker & Wilde, J. Electron. Packag. 123 (2001) 247: constants of the solder; the slab is the law",
    run,
)

"""A stressed strip that is carried through the grid: its stress must not notice the cells."""

import numpy as np

from core_models.errors import RunFailure
from studies.report.parts import MPM, Curve, Plot, Table
from studies.verification.bodies import strip_body
from studies.verification.convergence import neo_hookean
from studies.verification.outcome import Criterion, Outcome
from studies.verification.problem import Problem
from studies.verification.variant import Variant, attempt

YOUNG, DENSITY = 1e4, 1.0  # Pa, kg/m^3: waves run at 100 m/s
LENGTH, HEIGHT, SIZE = 2.0, 0.16, 0.02  # m
STRETCH = 1.05
VELOCITY = (30.0, 11.0)  # m/s
END = LENGTH / 400.0  # s; until then no wave from the free ends has reached the part that is watched
WATCHED = 0.125  # share of the length, on both sides of the middle
SMOOTH, ROUGH = 0.05, 0.3  # of the stress: allowed with smooth shape functions, and shown by linear ones

INTERPOLATIONS = ("linear", "gimp", "cpdi", "quadratic", "cubic")
CONTROL = "MPM linear"
VARIANTS = (
    *(Variant(f"MPM {name}", MPM, "quad4", {"interpolation": name}) for name in INTERPOLATIONS),
    Variant("MPM linear, total", MPM, "quad4", {"interpolation": "linear", "configuration": "total"}),
)


def carried(variant: Variant) -> dict[str, np.ndarray]:
    """Distance travelled in cells, and the largest error of the axial stress in the middle, step by step."""
    solver = variant.solver(
        strip_body(LENGTH, HEIGHT),
        neo_hookean(DENSITY, YOUNG / 3.0, YOUNG / 2.0),
        SIZE,
        geometry="plane-strain",
        displacement=lambda places: np.column_stack([(STRETCH - 1.0) * places[:, 0], np.zeros(len(places))]),
        velocity=np.array(VELOCITY),
    )
    watched = np.abs(solver.reference_positions[:, 0] / LENGTH - 0.5) < WATCHED
    exact = solver.points.old.stress[watched, 0].copy()
    times, errors = [0.0], [0.0]
    while solver.time < END:
        try:
            solver.advance(END)
        except RunFailure:
            if (
                variant.label == CONTROL
            ):  # its particles may be inverted by the jumps: they have been seen by then
                break
            raise
        times.append(solver.time)
        errors.append(float(np.abs(solver.points.old.stress[watched, 0] / exact - 1.0).max()))
    return {"cells": np.array(times) * VELOCITY[0] / SIZE, "error": np.array(errors)}


def run(quick: bool) -> Outcome:
    """All interpolations; it is always quick."""
    done, refused = attempt(VARIANTS, carried)
    outcome, rows = Outcome(), []
    for label, found in done.items():
        worst = float(found["error"].max())
        rows.append((label, 100.0 * worst))
        limits = {"low": 100.0 * ROUGH} if label == CONTROL else {"high": 100.0 * SMOOTH}
        what = "stress error shows the cells" if label == CONTROL else "stress error"
        outcome.criteria.append(Criterion(f"{what}, {label}", 100.0 * worst, **limits, unit="%"))
    outcome.criteria += [
        Criterion(
            f"stress error, {each.variant.label}", None, high=100.0 * SMOOTH, unit="%", reason=each.reason
        )
        for each in refused
    ]
    cells = VELOCITY[0] * END / SIZE
    note = f"Strip stretched by {STRETCH - 1.0:.0%}, carried through {cells:g} cells; the middle quarter is watched."
    outcome.tables.append(
        Table("Largest error of the axial stress", ("variant", "error [%]"), tuple(rows), note)
    )
    curves = tuple(
        Curve(label, tuple(found["cells"]), tuple(100.0 * found["error"]), MPM)
        for label, found in done.items()
    )
    outcome.plots.append(Plot("Error of the axial stress", "distance [cells]", "[%]", curves))
    return outcome


PROBLEM = Problem(
    "cell-crossing",
    "Stressed strip carried through the grid",
    "A long strip under uniform tension flies obliquely through the grid. Until the release from its ends arrives the "
    "stress in its middle is exactly constant. Linear shape functions, whose gradient jumps from cell to cell, are the "
    "negative control.",
    "hyperbolicity: no wave has arrived",
    run,
)

"""Axial vibration of a bar over a hundred periods."""

import numpy as np

from core_models.loads import Symmetry
from studies.report.parts import FEM, MPM, Curve, Plot, Table
from studies.verification.bodies import strip_body
from studies.verification.closed_forms.elastic_bodies import bar_period
from studies.verification.convergence import neo_hookean
from studies.verification.outcome import Criterion, Outcome
from studies.verification.problem import Problem
from studies.verification.variant import Variant, attempt

LENGTH, YOUNG, DENSITY = 25.0, 100.0, 1.0  # m, Pa, kg/m^3
SPEED = 0.1  # m/s
SIZE, HEIGHT = 1.0, 2.0  # m
PERIODS = {False: 100, True: 10}
WINDOW = 3  # periods over which an amplitude is taken
PERIOD_TOLERANCE, GROWTH_TOLERANCE = 5e-3, 1e-3

VARIANTS = (
    Variant("FEM quad4", FEM, "quad4"),
    Variant("FEM tri6", FEM, "tri6"),
    Variant("MPM quadratic, APIC", MPM, "quad4"),
    Variant("MPM quadratic, FLIP", MPM, "quad4", {"transfer": "flip", "flip_fraction": 1.0}),
    Variant("MPM quadratic, total", MPM, "quad4", {"configuration": "total"}),
)


def swing(variant: Variant, periods: int) -> tuple[np.ndarray, np.ndarray]:
    """Times [s] and displacement of the centroid along the bar [m], every step."""
    expected = bar_period(LENGTH, YOUNG, DENSITY)
    solver = variant.solver(
        strip_body(LENGTH, HEIGHT),
        neo_hookean(DENSITY, YOUNG / 3.0, YOUNG / 2.0),
        SIZE,
        geometry="plane-strain",
        velocity=lambda places: np.column_stack(
            [SPEED * np.sin(0.5 * np.pi * places[:, 0] / LENGTH), np.zeros(len(places))]
        ),
        loads=(Symmetry("left"),),
    )
    times, places = [0.0], [_centroid(solver)]
    while solver.time < periods * expected:
        solver.advance()
        times.append(solver.time)
        places.append(_centroid(solver))
    return np.array(times), np.array(places) - places[0]


def period(times: np.ndarray, displacement: np.ndarray) -> float:
    """Mean time between upward crossings of 0 [s]."""
    at = np.flatnonzero((displacement[:-1] < 0.0) & (displacement[1:] >= 0.0))
    share = displacement[at] / (displacement[at] - displacement[at + 1])
    crossings = times[at] + share * (times[at + 1] - times[at])
    return float((crossings[-1] - crossings[0]) / (len(crossings) - 1))


def growth(times: np.ndarray, displacement: np.ndarray) -> float:
    """Largest displacement in the last few periods over that in the first few, less 1."""
    span = WINDOW * bar_period(LENGTH, YOUNG, DENSITY)
    first, last = displacement[times <= span], displacement[times >= times[-1] - span]
    return float(np.abs(last).max() / np.abs(first).max() - 1.0)


def run(quick: bool) -> Outcome:
    """A hundred periods, or ten quickly."""
    periods, exact = PERIODS[quick], bar_period(LENGTH, YOUNG, DENSITY)
    done, refused = attempt(VARIANTS, lambda variant: swing(variant, periods))
    outcome, rows = Outcome(), []
    for label, (times, displacement) in done.items():
        off, grown = period(times, displacement) / exact - 1.0, growth(times, displacement)
        rows.append((label, exact * (1.0 + off), 100.0 * off, 100.0 * grown))
        outcome.criteria += [
            Criterion(
                f"period, {label}", 100.0 * off, -100.0 * PERIOD_TOLERANCE, 100.0 * PERIOD_TOLERANCE, "%"
            ),
            Criterion(
                f"growth over {periods} periods, {label}",
                100.0 * grown,
                high=100.0 * GROWTH_TOLERANCE,
                unit="%",
            ),
        ]
    outcome.criteria += [
        Criterion(f"period, {each.variant.label}", None, 0.0, 0.0, "%", each.reason) for each in refused
    ]
    note = f"{round(LENGTH / SIZE)} cells along the bar, {periods} periods of {exact:g} s."
    outcome.tables.append(
        Table(
            "Period and amplitude", ("variant", "period [s]", "off by [%]", "growth [%]"), tuple(rows), note
        )
    )
    outcome.plots.append(_last_periods(done, exact))
    return outcome


def _last_periods(done: dict, exact: float) -> Plot:
    curves = []
    for label, (times, displacement) in done.items():
        shown = times > times[-1] - 2.0 * exact
        family = FEM if label.startswith("FEM") else MPM
        curves.append(Curve(label, tuple(times[shown]), tuple(1e3 * displacement[shown]), family))
    return Plot("The last two periods", "t [s]", "displacement of the centroid [mm]", tuple(curves))


def _centroid(solver) -> float:
    return float(np.average(solver.point_positions()[:, 0], weights=solver.points.reference_volumes))


PROBLEM = Problem(
    "vibrating-bar",
    "Axial vibration of a bar",
    "A bar of 25 m, held at one end, swings in its first mode with strains of 1 %: its period, 4 L sqrt(rho / E), and "
    "its amplitude after a hundred periods, which must not grow.",
    "closed form of the linear bar",
    run,
)

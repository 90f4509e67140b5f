"""Elastica: a cantilever bent by a dead force at its end, at rest."""

import numpy as np

from core_models.loads import Damping, Fixed, Traction
from studies.report.parts import FEM, MPM, Curve, Plot, Table
from studies.verification.bodies import strip_body
from studies.verification.closed_forms.elastica import tip_state
from studies.verification.convergence import neo_hookean
from studies.verification.outcome import Criterion, Outcome
from studies.verification.problem import Problem
from studies.verification.variant import Variant, attempt, run_until
from studies.verification.variants import EVEN

LENGTH, HEIGHT = 1.0, 0.08  # m
YOUNG, DENSITY = 1.2e7, 1000.0  # Pa, kg/m^3; without Poisson's effect
LOADS = {False: (1.0, 2.0, 4.0), True: (2.0,)}  # P L^2 / (E I)
ACROSS = 4  # cells in the height
TOLERANCE = 0.01  # of the length
COARSE = (
    "MPM quadratic, 2 × 2 particles"  # too few to sample the stress of a beam that has turned: not judged
)
FIRST_MODE = 3.516 / LENGTH**2 * np.sqrt(YOUNG * HEIGHT**2 / (12.0 * DENSITY))  # rad/s, Bernoulli's beam
RAMP, REST = 1.0, 1.8  # periods of the first mode in which the force grows, and until the end

VARIANTS = (
    Variant("FEM quad4", FEM, "quad4"),
    Variant("MPM quadratic", MPM, "quad4", EVEN, finer=2),
    Variant(COARSE, MPM, "quad4", EVEN),
    Variant("MPM quadratic, total", MPM, "quad4", EVEN | {"configuration": "total"}),
)


def bent(variant: Variant, load: float) -> tuple[float, float]:
    """Deflection and shortening of the middle of the end, over the length, under the load P L^2 / (E I)."""
    force = load * YOUNG * HEIGHT**3 / (12.0 * LENGTH**2)  # N per m of thickness
    period = 2.0 * np.pi / FIRST_MODE

    def traction(places: np.ndarray, time: float) -> np.ndarray:
        share = min(time / (RAMP * period), 1.0)
        return np.tile([0.0, -force / HEIGHT * share**2 * (3.0 - 2.0 * share)], (len(places), 1))

    solver = variant.solver(
        strip_body(LENGTH, HEIGHT),
        neo_hookean(DENSITY, YOUNG / 3.0, YOUNG / 2.0),
        HEIGHT / ACROSS,
        geometry="plane-strain",
        loads=(Fixed("left"), Traction("right", traction), Damping(2.0 * FIRST_MODE)),
    )
    start = solver.boundary_positions("right").mean(axis=0)
    run_until(solver, REST * period)
    moved = solver.boundary_positions("right").mean(axis=0) - start
    return float(-moved[1] / LENGTH), float(-moved[0] / LENGTH)


def run(quick: bool) -> Outcome:
    """Both methods under several loads."""
    loads = LOADS[quick]
    done, refused = attempt(VARIANTS, lambda variant: [bent(variant, load) for load in loads])
    outcome, rows = Outcome(), []
    for label, found in done.items():
        for load, (deflection, shortening) in zip(loads, found, strict=True):
            exact = tip_state(load)
            rows.append((label, load, deflection, exact.deflection, shortening, exact.shortening))
            off = 100.0 * max(abs(deflection - exact.deflection), abs(shortening - exact.shortening))
            if label != COARSE:
                what = f"tip under {load:g}, {label}"
                outcome.criteria.append(Criterion(what, off, high=100.0 * TOLERANCE, unit="% of L"))
    outcome.criteria += [
        Criterion(
            f"tip, {each.variant.label}", None, high=100.0 * TOLERANCE, unit="% of L", reason=each.reason
        )
        for each in refused
    ]
    head = ("variant", "P L² / E I", "deflection / L", "exact", "shortening / L", "exact")
    note = f"Beam of L / h = {LENGTH / HEIGHT:g}, {ACROSS} cells in the height, brought to rest by damping."
    outcome.tables.append(Table("Tip of the cantilever", head, tuple(rows), note))
    outcome.plots.append(_plot(done, loads))
    return outcome


def _plot(done: dict, loads: tuple[float, ...]) -> Plot:
    fine = np.geomspace(0.1, 10.0, 60)
    curves = [Curve("elastica", tuple(fine), tuple(tip_state(load).deflection for load in fine), "exact")]
    curves += [
        Curve(
            label,
            loads,
            tuple(deflection for deflection, _ in found),
            FEM if label.startswith("FEM") else MPM,
        )
        for label, found in done.items()
    ]
    return Plot("Deflection of the tip", "P L² / E I", "deflection / L", tuple(curves))


PROBLEM = Problem(
    "cantilever",
    "Elastica cantilever",
    "A slender cantilever bent by a dead force until its end points almost along the force, brought to rest by "
    "mass-proportional damping: deflection and shortening of the tip against elliptic integrals.",
    "Bisshopp & Drucker, Quart. Appl. Math. 3 (1945) 272-275; Mattiasson, Int. J. Num. Meth. Eng. 17 (1981) 145-153",
    run,
)

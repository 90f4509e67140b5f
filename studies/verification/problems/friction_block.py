"""A block on a rough wall: it slides down a slope, sticks to it, or slides to rest."""

import numpy as np

from core_models.loads import BodyForce
from core_models.walls import Wall
from meshes.block import block
from meshes.mesh import Mesh
from studies.report.parts import FEM, MPM, Curve, Plot, Table
from studies.verification.convergence import neo_hookean
from studies.verification.outcome import Criterion, Outcome
from studies.verification.problem import Problem
from studies.verification.variant import Variant, attempt

YOUNG, DENSITY = 1e7, 1000.0  # Pa, kg/m^3: waves run at 100 m/s
LENGTH, HEIGHT, SIZE = 1.0, 0.5, 0.125  # m
G, FRICTION = 9.81, 0.3
RAMP, END = (
    0.1,
    0.5,
)  # s: the weight comes on in five periods of the block's own swing, so that it does not hop
SPEED = 1.0  # m/s, of the block that comes to rest
TOLERANCE = 0.01

VARIANTS = (
    Variant("FEM quad4", FEM, "quad4"),
    Variant("FEM hex8", FEM, "hex8"),
    Variant("MPM quadratic, APIC", MPM, "quad4"),
    Variant("MPM quadratic, APIC, 3-D", MPM, "hex8"),
)
CASES = {"slides": (0.5, 0.0), "sticks": (0.2, 0.0), "comes to rest": (0.0, SPEED)}
"""Tangent of the slope, and the block's speed at the start [m/s]."""


def way_of(time: float) -> float:
    """Way under an acceleration of 1 m/s^2 that grows from nothing in RAMP [m]; time [s], later than RAMP."""
    later = time - RAMP
    return RAMP**2 / 6.0 + 0.5 * RAMP * later + 0.5 * later**2


def exact_way(tangent: float, speed: float) -> float:
    """Way of a rigid block until END [m], by Coulomb."""
    slope = np.arctan(tangent)
    drive = G * (np.sin(slope) - FRICTION * np.cos(slope))
    if drive >= 0.0:
        return speed * END + drive * way_of(END)
    if speed == 0.0:
        return 0.0
    stop = speed / -drive + 0.5 * RAMP
    return speed * stop + drive * way_of(stop)


def slid(variant: Variant, tangent: float, speed: float) -> dict[str, np.ndarray | float]:
    """Time [s] and mean way of the foot along the wall [m], step by step; friction over the wall's impulse at last,
    and the relative error of the energy.
    """
    d = 2 if variant.kind == "quad4" else 3
    slope, along, up = np.arctan(tangent), np.eye(d)[0], np.eye(d)[-1]
    pull = G * (np.sin(slope) * along - np.cos(slope) * up)
    solver = variant.solver(
        _body,
        neo_hookean(DENSITY, YOUNG / 3.0, YOUNG / 2.0),
        SIZE,
        geometry="plane-strain" if d == 2 else "spatial",
        velocity=speed * along,
        wall=Wall("unilateral", FRICTION),
        loads=(BodyForce(lambda places, time: np.tile(min(time / RAMP, 1.0) * pull, (len(places), 1))),),
    )
    start = solver.boundary_positions("bottom")[:, 0].mean()
    times, way = [0.0], [0.0]
    while solver.time < END:
        solver.advance(END)
        times.append(solver.time)
        way.append(float(solver.boundary_positions("bottom")[:, 0].mean() - start))
    return {"time": np.array(times), "way": np.array(way), "energy": solver.ledger.relative_error}


def run(quick: bool) -> Outcome:
    """Three cases by both methods in two and three dimensions; it is always quick."""
    outcome, rows = Outcome(), []
    for case, (tangent, speed) in CASES.items():
        done, refused = attempt(
            VARIANTS, lambda variant, tangent=tangent, speed=speed: slid(variant, tangent, speed)
        )
        exact = exact_way(tangent, speed)
        scale = exact or G * np.sin(np.arctan(tangent)) * way_of(END)
        for label, found in done.items():
            off = 100.0 * (found["way"][-1] - exact) / scale
            rows.append((f"{label}, {case}", found["way"][-1], exact, off, 100.0 * found["energy"]))
            what = f"way of the block that {case}, {label}"
            outcome.criteria.append(Criterion(what, off, -100.0 * TOLERANCE, 100.0 * TOLERANCE, "%"))
        outcome.criteria += [
            Criterion(f"block that {case}, {each.variant.label}", None, 0.0, 0.0, "%", each.reason)
            for each in refused
        ]
        outcome.plots.append(_plot(case, exact, done))
    note = (
        f"Friction {FRICTION:g}; slopes of tangent {CASES['slides'][0]:g} and {CASES['sticks'][0]:g}, and a level wall "
        f"with {SPEED:g} m/s at the start. Of the block that sticks the way is compared with that without friction."
    )
    head = ("variant", "way [m]", "exact [m]", "off by [%]", "energy off by [%]")
    outcome.tables.append(Table(f"Way of the foot after {END:g} s", head, tuple(rows), note))
    return outcome


def _body(size: float, kind: str) -> Mesh:
    if kind == "quad4":
        return block([0.0, 0.0], [LENGTH, HEIGHT], [round(LENGTH / size), round(HEIGHT / size)], kind)
    upper = [LENGTH, HEIGHT, HEIGHT]
    return block([0.0] * 3, upper, [round(side / size) for side in upper], kind)


def _plot(case: str, exact: float, done: dict) -> Plot:
    curves = [Curve("rigid block at the end", (0.0, END), (exact, exact), "exact")]
    curves += [
        Curve(label, tuple(found["time"]), tuple(found["way"]), FEM if label.startswith("FEM") else MPM)
        for label, found in done.items()
    ]
    return Plot(f"The block {case}", "t [s]", "way of the foot [m]", tuple(curves))


PROBLEM = Problem(
    "friction-block",
    "Block on a rough wall",
    "A soft elastic block under its weight, which comes on gradually: it slides down a steep slope, sticks to a flat "
    "one, and slides to rest on a level wall. Its way against that of a rigid block under Coulomb's law.",
    "Coulomb; closed form of the rigid block",
    run,
)

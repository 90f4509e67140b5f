"""Two elastic disks that meet and part, in one velocity field."""

import numpy as np

from meshes.disk import disk
from meshes.join import join
from studies.report.parts import MPM, Curve, Plot, Table
from studies.verification.convergence import neo_hookean
from studies.verification.outcome import Criterion, Outcome
from studies.verification.problem import Problem
from studies.verification.variant import Variant, attempt

YOUNG, POISSON, DENSITY = 1000.0, 0.3, 1000.0  # Pa, -, kg/m^3
RADIUS, CENTRES, SPEED = 0.2, ((0.2, 0.2), (0.8, 0.8)), 0.1  # m, m, m/s along both axes
SIZE = 0.05  # m
CFL = 0.025  # the published step, 1 ms
END = 3.5  # s
GEOMETRIC_CONTACT = 1.5858  # s
KINETIC = 2.513  # J per m of thickness, of round disks
KEPT, RECOVERED = (
    0.95,
    0.8,
)  # shares of the energy: kinetic and strain, kinetic alone, once the disks are apart
ROUND_OFF, ENERGY_TOLERANCE = 1e-12, 0.02

FLIP = {"transfer": "flip", "flip_fraction": 1.0}
VARIANTS = (
    Variant("MPM linear, FLIP", MPM, "quad4", FLIP | {"interpolation": "linear"}),
    Variant("MPM GIMP, FLIP", MPM, "quad4", FLIP | {"interpolation": "gimp"}),
    Variant("MPM quadratic, FLIP", MPM, "quad4", FLIP),
    Variant("MPM quadratic, APIC", MPM, "quad4"),
)
JUDGED = {variant.label for variant in VARIANTS[:3]}  # APIC dissipates at each of so many steps


def collide(variant: Variant, size: float) -> dict[str, np.ndarray]:
    """Time [s], kinetic and strain energy [J], total energy's error, momentum relative to one disk's, step by step."""
    solver = variant.solver(
        lambda size, kind: join([disk(RADIUS, size, kind, centre) for centre in CENTRES]),
        neo_hookean(DENSITY, YOUNG / (3.0 * (1.0 - 2.0 * POISSON)), 0.5 * YOUNG / (1.0 + POISSON)),
        size,
        cfl=CFL,
        geometry="plane-strain",
        velocity=lambda places: np.where(places.sum(axis=1, keepdims=True) < 1.0, SPEED, -SPEED) * np.ones(2),
    )
    scale = 0.5 * solver.mass * SPEED * np.sqrt(2.0)
    rows = [_state(solver, scale)]
    while solver.time < END:
        solver.advance(END)
        rows.append(_state(solver, scale))
    names = ("time", "kinetic", "strain", "error", "momentum")
    return dict(zip(names, np.array(rows).T, strict=True))


def _state(solver, scale: float) -> tuple[float, ...]:
    ledger = solver.ledger
    momentum = float(np.linalg.norm(solver.momentum)) / scale
    return solver.time, ledger.kinetic, ledger.strain, ledger.relative_error, momentum


def run(quick: bool) -> Outcome:
    """All variants at the published size of cells; it is always quick."""
    done, refused = attempt(VARIANTS, lambda variant: collide(variant, SIZE))
    outcome, rows = Outcome(), []
    for label, found in done.items():
        start, lowest, last = found["kinetic"][0], found["kinetic"].min(), found["kinetic"][-1]
        contact = found["time"][np.argmax(found["kinetic"] < 0.99 * start)]
        momentum, error = found["momentum"].max(), np.abs(found["error"]).max()
        kept = last + found["strain"][-1]
        rows.append(
            (label, start, contact, lowest / start, last / start, kept / start, 100.0 * error, momentum)
        )
        if label in JUDGED:
            outcome.criteria += [
                Criterion(
                    f"kinetic energy at the end, {label}", last / start, low=RECOVERED, high=1.0 + 1e-9
                ),
                Criterion(f"kinetic and strain energy at the end, {label}", kept / start, low=KEPT),
                Criterion(f"energy balance, {label}", 100.0 * error, high=100.0 * ENERGY_TOLERANCE, unit="%"),
                Criterion(f"momentum, {label}", momentum, high=ROUND_OFF),
            ]
    outcome.criteria += [
        Criterion(f"energies, {each.variant.label}", None, low=RECOVERED, reason=each.reason)
        for each in refused
    ]
    head = (
        "variant", "kinetic at start [J]", "contact felt [s]", "least kinetic", "kinetic at the end",
        "kinetic and strain", "balance off by [%]", "momentum",
    )  # fmt: skip
    note = (
        f"Energies relative to the start. Round disks have {KINETIC} J and would touch at "
        f"{GEOMETRIC_CONTACT} s; in one velocity field they feel each other as soon as they share nodes, earlier by "
        "the width of the shape functions."
    )
    outcome.tables.append(Table("Energies and momentum", head, tuple(rows), note))
    outcome.plots = [_energies(done, name) for name in ("kinetic", "strain")]
    return outcome


def _energies(done: dict, name: str) -> Plot:
    curves = tuple(
        Curve(label, tuple(found["time"]), tuple(found[name]), MPM) for label, found in done.items()
    )
    return Plot(f"{name.capitalize()} energy", "t [s]", "[J]", curves)


PROBLEM = Problem(
    "two-disks",
    "Two elastic disks",
    "Two disks fly at each other, are squeezed, and part. In one velocity field contact comes by itself. Momentum "
    "stays zero, total energy is kept, and the kinetic energy comes back but for what the disks keep swinging with.",
    "Sulsky, Chen & Schreyer, Comput. Methods Appl. Mech. Eng. 118 (1994) 179-196",
    run,
)

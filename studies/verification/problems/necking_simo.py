"""The round bar that necks, by implicit finite elements and three other ways, against two other codes."""

import csv
from dataclasses import replace
from pathlib import Path
from statistics import median

import numpy as np

from core_models.errors import MatpointError
from studies.bar_necking import (
    HYPOELASTIC,
    NECKING_SIMO,
    NeckingHistory,
    at_elongation,
    peak,
    simo_steel,
    uniform_peak,
)
from studies.necking_methods import NeckingMesh, NeckingRun, explicit_fem_run, implicit_run, total_mpm_run
from studies.shipped_scenes import SCENES_FOLDER
from studies.verification.outcome import Criterion, Curve, Outcome, Plot, Table
from studies.verification.problem import Problem
from studies.verification.variant import FEM, MPM

REFERENCE = (
    ("peak force", 77.3, 0.003), ("force at 4 mm", 71.2, 0.005), ("force at 5 mm", 59.5, 0.007),
    ("force at 6 mm", 43.1, 0.015), ("neck radius at 5 mm", 4.485, 0.005), ("neck radius at 6 mm", 3.48, 0.012),
)  # fmt: skip
"""Quantity, value [kN or mm] between those of the two other codes, and the relative difference that is allowed."""

PEAK_AT = (2.83, 0.05)  # mm, and what is allowed
OTHERS = {"peak force": 0.01, "neck radius at 5 mm": 0.02, "neck radius at 6 mm": 0.04}
"""How far other methods may be from implicit elements, relatively."""

FINE = NeckingMesh(10, 40, 0.05)
MESHES = (NeckingMesh(5, 20, 0.2), NeckingMesh(8, 24, 0.17), FINE)
EXPLICIT, PARTICLES = NeckingMesh(8, 24, 0.17), NeckingMesh(12, 50)
INCREMENTS = 250
PERIODS = {"fem-explicit": 300.0, "mpm-tl": 400.0}
PEERS = SCENES_FOLDER / "necking-simo-peers.csv"


def run(quick: bool) -> Outcome:
    """Implicit runs of several meshes and increments; unless quick, the explicit methods too."""
    outcome = Outcome()
    best = implicit_run(NECKING_SIMO, FINE, INCREMENTS)
    coarse_steps = implicit_run(NECKING_SIMO, FINE, 10, tolerance=1e-11)
    static = [best, coarse_steps]
    if quick:
        runs = [best]
    else:
        fifty = implicit_run(NECKING_SIMO, FINE, 50)
        double = implicit_run(NECKING_SIMO, FINE, 500)
        static += [fifty, double]
        static += [implicit_run(NECKING_SIMO, mesh, INCREMENTS) for mesh in MESHES[:-1]]
        static.append(_quadratic())
        static.append(implicit_run(NECKING_SIMO, FINE, 50, "fem-implicit:none", cure="none"))
        others = _others(outcome)
        runs = [best, *others]
        outcome.criteria += [_without_cut(fifty), _same_end(best, double)]
        outcome.criteria += [each for other in others for each in _against(other, best)]
    outcome.criteria = [*_reference_criteria(best), *_uniform(), *_newton(coarse_steps), *outcome.criteria]
    outcome.tables = [
        _quantity_table([*static, *runs[1:]]),
        _neck_table(best),
        _cost_table([*static, *runs[1:]]),
    ]
    outcome.plots = [
        _plot(runs, "force", "force [kN]", 1e-3),
        _plot(runs, "neck_radius", "neck radius [mm]", 1e3),
    ]
    outcome.remarks.append(
        "At 7 mm the answer follows the mesh and, in the other codes too, the increment: compare it for one mesh only. "
        "Elements with full integration and no cure (fem-implicit:none) lock: they keep too much force."
    )
    return outcome


def measured(run: NeckingRun) -> dict[str, float | None]:
    """Quantities of a run by name [kN, mm]."""
    history = run.history
    at, force = peak(history)
    found = {"peak force": 1e-3 * force, "elongation at peak": 1e3 * at}
    for u in (4, 5, 6, 7):
        found[f"force at {u} mm"] = _scaled(at_elongation(history, "force", 1e-3 * u), 1e-3)
    for u in (5, 6, 7):
        found[f"neck radius at {u} mm"] = _scaled(at_elongation(history, "neck_radius", 1e-3 * u), 1e3)
    return found


def _scaled(value: float | None, factor: float) -> float | None:
    return None if value is None else factor * value


def _quadratic() -> NeckingRun:
    return implicit_run(
        NECKING_SIMO, FINE, INCREMENTS, "fem-implicit:quad8+reduced", "quad8", integration="reduced"
    )


def _others(outcome: Outcome) -> list[NeckingRun]:
    done = []
    for name, make in (
        ("fem-explicit", lambda: explicit_fem_run(NECKING_SIMO, EXPLICIT, PERIODS["fem-explicit"])),
        ("mpm-tl", lambda: total_mpm_run(NECKING_SIMO, PARTICLES, PERIODS["mpm-tl"])),
    ):
        try:
            done.append(make())
        except MatpointError as reason:
            outcome.criteria.append(Criterion(f"{name} runs to the end", None, reason=str(reason)))
    return done


def _reference_criteria(best: NeckingRun) -> list[Criterion]:
    found = measured(best)
    units = {True: "kN", False: "mm"}
    criteria = [
        Criterion(
            f"{name}, {best.label}",
            found[name],
            value * (1.0 - part),
            value * (1.0 + part),
            units["force" in name],
        )
        for name, value, part in REFERENCE
    ]
    at, around = PEAK_AT
    name = "elongation at peak"
    return [*criteria, Criterion(f"{name}, {best.label}", found[name], at - around, at + around, "mm")]


def _uniform() -> list[Criterion]:
    """Without a taper the bar stays a cylinder up to the maximum of the closed form."""
    criteria = []
    for name, material in (("hyperelastic", NECKING_SIMO.material), (HYPOELASTIC, simo_steel(HYPOELASTIC))):
        scene = replace(NECKING_SIMO, material=material, taper=1.0, pull=4e-3)
        force = peak(implicit_run(scene, NeckingMesh(1, 2), 100).history)[1]
        exact = uniform_peak(material, scene.radius)
        what = f"peak force without taper, {name}, closed form {1e-3 * exact:.2f} kN"
        criteria.append(Criterion(what, 1e-3 * force, 0.999e-3 * exact, 1.001e-3 * exact, "kN"))
    return criteria


def _newton(run: NeckingRun) -> list[Criterion]:
    lowest = f" (lowest {min(run.orders):.2f})" if run.orders else ""
    what = f"Newton's order, median of {len(run.orders)} attempts that qualify{lowest}, {run.label}"
    order = median(run.orders) if run.orders else None
    return [
        Criterion(what, order, 1.8, reason="no attempt has three corrections with the same flowing points")
    ]


def _without_cut(run: NeckingRun) -> Criterion:
    return Criterion(f"cuts, {run.label}", float(run.cuts), 0.0, 0.0)


def _same_end(one: NeckingRun, two: NeckingRun) -> Criterion:
    name = "force at 7 mm"
    difference = measured(one)[name] / measured(two)[name] - 1.0
    return Criterion(f"{name}, {one.label} against {two.steps}", 100.0 * difference, -1.0, 1.0, "%")


def _against(other: NeckingRun, best: NeckingRun) -> list[Criterion]:
    ours, theirs = measured(best), measured(other)
    return [
        Criterion(
            f"{name}, {other.label} against {best.method}", 100.0 * (theirs[name] / ours[name] - 1.0), -100.0 * part,
            100.0 * part, "%",
        )
        for name, part in OTHERS.items()
    ]  # fmt: skip


def _quantity_table(runs: list[NeckingRun]) -> Table:
    rows = [(each.label, *measured(each).values()) for each in runs]
    rows.append(("two other codes", *_peer_values()))
    head = ("run", *(f"{name} [{'kN' if 'force' in name else 'mm'}]" for name in measured(runs[0])))
    note = (
        "Elongations are those of one half; force and neck radius at an elongation by linear interpolation."
    )
    return Table("Quantities", head, tuple(rows), note)


def _peer_values() -> list[str]:
    values = {name: value for name, value, _part in REFERENCE} | {"elongation at peak": PEAK_AT[0]}
    names = ("peak force", "elongation at peak", *(f"force at {u} mm" for u in (4, 5, 6, 7)))
    names += tuple(f"neck radius at {u} mm" for u in (5, 6, 7))
    return [values.get(name) for name in names]


def _neck_table(run: NeckingRun) -> Table:
    rows = []
    for u in (2.0, 3.0, 4.0, 5.0, 6.0, 7.0):
        row = [at_elongation(run.history, name, 1e-3 * u) for name in NeckingHistory.COLUMNS[3:]]
        rows.append((f"{u:g} mm", *row[:4], 1e-6 * row[4], 1e-6 * row[5]))
    head = (
        "elongation", "plastic strain, centre", "triaxiality, centre", "plastic strain, surface",
        "triaxiality, surface", "flow stress, centre [MPa]", "flow stress by Bridgman [MPa]",
    )  # fmt: skip
    note = "Bridgman: mean axial stress over the neck's section times his factor for the measured profile."
    return Table(f"In the neck, {run.label}", head, tuple(rows), note)


def _cost_table(runs: list[NeckingRun]) -> Table:
    rows = tuple(
        (
            each.label, each.seconds, each.steps, each.iterations or None, each.cuts if each.iterations else None,
            f"{100.0 * each.kinetic_share:.2g} %", ", ".join(f"{order:.2f}" for order in each.orders),
        )
        for each in runs
    )  # fmt: skip
    head = (
        "run",
        "processor s",
        "increments or steps",
        "iterations",
        "cuts",
        "kinetic share",
        "Newton's orders",
    )
    return Table("Cost", head, rows, "Processor time of the first run holds compilation where there was any.")


def _plot(runs: list[NeckingRun], column: str, label: str, scale: float) -> Plot:
    curves = [
        Curve(
            each.label,
            tuple(1e3 * each.history.column("elongation")),
            tuple(scale * each.history.column(column)),
            MPM if each.method.startswith("mpm") else FEM,
        )
        for each in runs
    ]
    return Plot(f"{label.capitalize().split(' [')[0]} over elongation", "elongation of one half [mm]", label,
                (*curves, *_peer_curves(column, scale)))  # fmt: skip


def _peer_curves(column: str, scale: float) -> list[Curve]:
    table = read_peers(PEERS)
    return [
        Curve(name, tuple(1e3 * table["elongation"]), tuple(scale * table[f"{key}_{column}"]), "exact")
        for name, key in (("CalculiX 2.20", "calculix"), ("fedoo 1.1.0", "fedoo"))
    ]


def read_peers(path: Path) -> dict[str, np.ndarray]:
    """Columns of the curves of other codes by name, in SI units."""
    lines = [line for line in path.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
    names, *rows = csv.reader(lines)
    return dict(zip(names, np.array(rows, dtype=np.float64).T, strict=True))


PROBLEM = Problem(
    "necking-simo",
    "Necking of a round bar",
    "Half a steel bar, slightly tapered, is pulled until it necks; its end is free to contract. Force and radius of "
    "the neck over the elongation by implicit finite elements, against two other codes on the same mesh, by explicit "
    "finite elements and by the material point method.",
    "Simo, Comput. Methods Appl. Mech. Eng. 99 (1992) 61; CalculiX 2.20 and fedoo 1.1.0 run for comparison",
    run,
)

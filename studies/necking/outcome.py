"""What the runs of a necking scene say: criteria, tables, curves over each other."""

from studies.necking.bar_necking import at_elongation
from studies.necking.curves import read_curve
from studies.necking.run import NeckingRun
from studies.necking.scene import STRIP, NeckingScene
from studies.necking.verdicts import SCALES, Runs, criteria_of, limits_table, shown_name, value_of
from studies.report.parts import FEM, MPM, Curve, Plot, Table
from studies.verification.outcome import Criterion, Outcome

MARKS = 7  # elongations in the tables

NECK = {
    "centre_plastic_strain": ("plastic strain, centre", 1.0),
    "surface_plastic_strain": ("plastic strain, surface", 1.0),
    "centre_triaxiality": ("triaxiality, centre", 1.0), "surface_triaxiality": ("triaxiality, surface", 1.0),
    "flow_stress": ("flow stress, centre [MPa]", 1e-6), "bridgman_flow": ("flow stress by Bridgman [MPa]", 1e-6),
    "axial_stress": ("axial stress, centre [MPa]", 1e-6), "bridgman_axial": ("axial stress by Bridgman [MPa]", 1e-6),
    "temperature": ("temperature, centre [K]", 1.0), "damage": ("damage, centre", 1.0),
}  # fmt: skip
"""Columns of the table of what happens in the neck: what they are called, and their scale."""

WHOLE = (
    "peak_force", "elongation_at_peak", "force_at_end", "neck_radius_at_end", "fracture_elongation", "load_drop",
    "first_failure", "place_of_first_failure",
)  # fmt: skip


def outcome_of(scene: NeckingScene, runs: Runs, failures: dict[str, str]) -> Outcome:
    """The outcome of the runs, and of those that have not come to their ends, by the reasons why.

    Of a run that has stopped on its way there are curves, shape and cost, but nothing is concluded from it.
    """
    outcome = Outcome()
    complete = {name: run for name, run in runs.items() if not run.stopped}
    outcome.criteria = criteria_of(scene, complete)
    outcome.criteria += [
        Criterion(f"{name} runs to the end", None, reason=why) for name, why in failures.items()
    ]
    plans = [plan for plan in scene.runs if plan.name in runs]
    outcome.tables = [_quantities(scene, complete), limits_table(scene, complete), _cost(scene, runs)]
    outcome.tables += [
        _in_the_neck(scene, plan.label, runs[plan.name]) for plan in plans if _shown(plan, plans)
    ]
    outcome.plots = [
        _plot(scene, runs, "force", "force [kN]", 1e-3),
        _plot(scene, runs, "neck_radius", "neck radius [mm]", 1e3),
        _plot(scene, runs, "centre_triaxiality", "triaxiality at the centre", 1.0),
    ]
    outcome.remarks = [f"{plan.label}: {plan.note}." for plan in plans if plan.note]
    outcome.seconds = sum(run.seconds for run in runs.values())
    return outcome


def _shown(plan, plans) -> bool:
    """The first run of each method has a table of its own."""
    return plan is next(each for each in plans if each.method == plan.method)


def _marks(scene: NeckingScene) -> list[float]:
    return [scene.pull * (i + 1) / MARKS for i in range(MARKS)]


def _quantities(scene: NeckingScene, runs: Runs) -> Table:
    at = [(name, u) for name in ("force", "neck_radius") for u in _marks(scene)[3:]]
    head = ["run"]
    columns = [(name, None) for name in WHOLE] + at
    values = {
        plan.label: [value_of(runs[plan.name], name, u) for name, u in columns]
        for plan in scene.runs
        if plan.name in runs
    }
    kept = [i for i in range(len(columns)) if any(row[i] is not None for row in values.values())]
    for i in kept:
        unit = SCALES.get(columns[i][0], (1.0, ""))[1]
        head.append(shown_name(*columns[i]) + (f" [{unit}]" if unit else ""))
    rows = [
        (label, *(None if row[i] is None else SCALES.get(columns[i][0], (1.0,))[0] * row[i] for i in kept))
        for label, row in values.items()
    ]
    note = (
        "Elongations are those of one half; force and neck radius at an elongation by linear interpolation."
    )
    if scene.body == STRIP:
        note += " Of a strip: the force on a quarter of 1 m thickness, and half the width."
    return Table("Quantities", tuple(head), tuple(rows), note)


def _in_the_neck(scene: NeckingScene, label: str, run) -> Table:
    names = [name for name in NECK if run.history.column(name).any()]
    rows = []
    for u in _marks(scene):
        values = [at_elongation(run.history, name, u) for name in names]
        if None not in values:
            scaled = [NECK[name][1] * value for name, value in zip(names, values, strict=True)]
            rows.append((f"{1e3 * u:.3g} mm", *scaled))
    head = ("elongation", *(NECK[name][0] for name in names))
    note = (
        "Bridgman: from the mean axial stress over the neck's section and the measured profile, the flow stress by his "
        "factor, and the axial stress at the centre."
    )
    return Table(f"In the neck, {label}", head, tuple(rows), "" if scene.body == STRIP else note)


def _cost(scene: NeckingScene, runs: Runs) -> Table:
    rows = tuple(
        (
            plan.label, runs[plan.name].seconds, runs[plan.name].steps, runs[plan.name].iterations or None,
            runs[plan.name].cuts if plan.increments else None, f"{100.0 * runs[plan.name].kinetic_share:.2g} %",
            _orders(runs[plan.name]) if plan.increments else "",
        )
        for plan in scene.runs
        if plan.name in runs
    )  # fmt: skip
    head = (
        "run", "processor s", "increments or steps", "iterations", "cuts", "kinetic share", "Newton's orders",
    )  # fmt: skip
    total = sum(run.seconds for run in runs.values())
    note = f"Together {total:.0f} s of processor time, compilation among it where there was any."
    return Table("Cost", head, rows, note)


def _orders(run: NeckingRun) -> str:
    shown = ", ".join(f"{order:.2f}" for order in run.orders)
    return f"{len(run.orders)} of {run.steps + run.cuts} attempts qualify" + (f": {shown}" if shown else "")


def _plot(scene: NeckingScene, runs: Runs, column: str, label: str, scale: float) -> Plot:
    plans = [plan for plan in scene.runs if plan.name in runs and plan.taper is None]
    curves = [
        Curve(
            plan.name + (" (stopped)" if runs[plan.name].stopped else ""),
            tuple(1e3 * runs[plan.name].history.column("elongation")),
            tuple(scale * runs[plan.name].history.column(column)),
            MPM if plan.method.startswith("mpm") else FEM,
        )
        for plan in plans
    ]
    for curve in scene.curves:
        if column in curve.columns:
            x, y = read_curve(curve, column)
            curves.append(Curve(curve.label, tuple(1e3 * x), tuple(scale * y), "exact"))
    title = f"{label.split(' [')[0].capitalize()} over elongation"
    return Plot(title, "elongation of one half [mm]", label, tuple(curves))

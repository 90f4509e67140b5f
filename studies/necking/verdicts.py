"""What a necking scene must show, checked on its runs."""

from collections.abc import Mapping

import numpy as np

from studies.comparisons.convergence import extrapolate
from studies.necking.bar_necking import quantity, uniform_peak
from studies.necking.curves import read_curve
from studies.necking.run import NeckingRun
from studies.necking.scene import (
    COUNTS,
    Agreement,
    Check,
    Expected,
    Limits,
    Nearness,
    NeckingScene,
    NewtonOrder,
    PlannedRun,
    UniformPeak,
)
from studies.report.parts import Table
from studies.scenes.material_finder import with_update
from studies.verification.outcome import Criterion

Runs = Mapping[str, NeckingRun]

SCALES = {
    "force": (1e-3, "kN"), "peak_force": (1e-3, "kN"), "force_at_end": (1e-3, "kN"), "neck_radius": (1e3, "mm"),
    "neck_radius_at_end": (1e3, "mm"), "elongation_at_peak": (1e3, "mm"), "fracture_elongation": (1e3, "mm"),
    "first_failure": (1e3, "mm"), "load_drop": (1e3, "mm"), "temperature": (1.0, "K"),
    "kinetic_share": (100.0, "%"), "strained_share": (100.0, "%"),
}  # fmt: skip
"""Quantity: factor from SI to what is shown, and its unit."""


def criteria_of(scene: NeckingScene, runs: Runs) -> list[Criterion]:
    """The scene's checks of those runs that have been made."""
    made = [check for check in scene.checks if set(_runs_of(check)) <= set(runs)]
    return [_VERDICTS[type(check)](check, scene, runs) for check in made]


def value_of(run: NeckingRun, name: str, at: float | None = None) -> float | None:
    """A quantity of a run, in SI."""
    return float(getattr(run, name)) if name in COUNTS else quantity(run.history, name, at)


def shown_name(name: str, at: float | None = None) -> str:
    """A quantity in words."""
    return name.replace("_", " ") + ("" if at is None else f" at {1e3 * at:g} mm")


def limits_table(scene: NeckingScene, runs: Runs) -> Table:
    """Limits of the families of runs, with their uncertainties."""
    rows = []
    for check in scene.checks:
        if not isinstance(check, Limits) or not set(_runs_of(check)) <= set(runs):
            continue
        factor, unit = SCALES.get(check.quantity, (1.0, ""))
        for names in (check.runs, check.others):
            limit = _limit(check, names, scene, runs)
            values = [factor * value_of(runs[name], check.quantity, check.at) for name in names]
            rows.append(
                (
                    f"{shown_name(check.quantity, check.at)} [{unit}], {', '.join(names)}",
                    *values, factor * limit.value, factor * limit.uncertainty, limit.order or "",
                )
            )  # fmt: skip
    head = ("quantity", "coarse", "middle", "fine", "limit", "uncertainty", "order")
    return Table("Limits of refined meshes", head, tuple(rows), "By least squares in the element's size.")


def _runs_of(check: Check) -> tuple[str, ...]:
    if isinstance(check, Limits):
        return check.runs + check.others
    return (check.run, check.other) if isinstance(check, Agreement) else (check.run,)


def _label(scene: NeckingScene, name: str) -> str:
    return _plan(scene, name).label


def _plan(scene: NeckingScene, name: str) -> PlannedRun:
    return next(plan for plan in scene.runs if plan.name == name)


def _expected(check: Expected, scene: NeckingScene, runs: Runs) -> Criterion:
    factor, unit = SCALES.get(check.quantity, (1.0, ""))
    value = value_of(runs[check.run], check.quantity, check.at)
    source = f"; {check.source}" if check.source else ""
    return Criterion(
        f"{shown_name(check.quantity, check.at)}, {_label(scene, check.run)}{source}",
        None if value is None else factor * value, factor * check.low, factor * check.high, unit,
        "the run has no such value",
    )  # fmt: skip


def _agreement(check: Agreement, scene: NeckingScene, runs: Runs) -> Criterion:
    ours, theirs = (value_of(runs[name], check.quantity, check.at) for name in (check.run, check.other))
    known = ours is not None and theirs is not None
    part = 100.0 * check.within
    return Criterion(
        f"{shown_name(check.quantity, check.at)}, {_label(scene, check.run)} against {check.other}",
        100.0 * (ours / theirs - 1.0) if known else None, -part, part, "%", "a run did not get there",
    )  # fmt: skip


def _nearness(check: Nearness, scene: NeckingScene, runs: Runs) -> Criterion:
    curve = next(curve for curve in scene.curves if curve.label == check.curve)
    x, y = read_curve(curve, check.quantity)
    within = (x >= check.beyond) & (x <= check.up_to)
    history = runs[check.run].history
    ours = np.interp(x[within], history.column("elongation"), history.column(check.quantity))
    apart = ours / y[within] - 1.0
    worst = int(np.abs(apart).argmax())
    return Criterion(
        f"{shown_name(check.quantity)} up to {1e3 * check.up_to:g} mm, {_label(scene, check.run)} against "
        f"{check.curve}, worst at {1e3 * x[within][worst]:.3g} mm",
        100.0 * float(apart[worst]), -100.0 * check.within, 100.0 * check.within, "%",
    )  # fmt: skip


def _limit(check: Limits, names: tuple[str, ...], scene: NeckingScene, runs: Runs):
    resolutions = [_plan(scene, name).across for name in names]
    return extrapolate(resolutions, [value_of(runs[name], check.quantity, check.at) for name in names])


def _same_limit(check: Limits, scene: NeckingScene, runs: Runs) -> Criterion:
    ours, theirs = (_limit(check, names, scene, runs) for names in (check.runs, check.others))
    doubt = 100.0 * (ours.uncertainty + theirs.uncertainty) / theirs.value
    return Criterion(
        f"limit of {shown_name(check.quantity, check.at)}, {', '.join(check.runs)} against {', '.join(check.others)}, "
        "within what is uncertain",
        100.0 * (ours.value / theirs.value - 1.0), -doubt, doubt, "%",
    )  # fmt: skip


def _newton(check: NewtonOrder, scene: NeckingScene, runs: Runs) -> Criterion:
    orders = runs[check.run].orders
    what = f"Newton's order, lowest of {len(orders)} attempts that qualify, {_label(scene, check.run)}"
    reason = "no attempt has three corrections with the same flowing points"
    return Criterion(what, min(orders, default=None), check.least, reason=reason)


def _uniform_peak(check: UniformPeak, scene: NeckingScene, runs: Runs) -> Criterion:
    plan = _plan(scene, check.run)
    material = scene.material if plan.update is None else with_update(scene.material, plan.update)
    exact = 1e-3 * uniform_peak(material, scene.radius)
    part = check.within * exact
    return Criterion(
        f"peak force of a cylinder, {plan.label}, closed form {exact:.2f} kN",
        1e-3 * value_of(runs[check.run], "peak_force"), exact - part, exact + part, "kN",
    )  # fmt: skip


_VERDICTS = {
    Expected: _expected,
    Agreement: _agreement,
    Nearness: _nearness,
    Limits: _same_limit,
    NewtonOrder: _newton,
    UniformPeak: _uniform_peak,
}

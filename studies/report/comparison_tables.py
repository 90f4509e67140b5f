"""The tables of a comparison's report."""

from studies.comparisons.comparison import Comparison
from studies.methods.method import find_method
from studies.observers.history import ENERGIES
from studies.output.display import (
    ABSENT,
    number,
    plus_minus,
    shown,
    shown_name,
    shown_percent,
    shown_title,
    shown_unit,
    with_unit,
)
from studies.report.parts import Table
from studies.runs.result import RunResult
from studies.scenes.effects import scene_effects


def quantities_table(comparison: Comparison, notes: str) -> Table:
    """Every quantity: finest value and limit of each method, the difference."""
    finest = comparison.finest
    head = ["quantity"]
    for run in finest:
        label = find_method(run.method).label
        head += [f"{label} {run.resolution}", f"{label} limit"]
    apart = {difference.quantity: difference for difference in comparison.differences}
    if comparison.differences:
        head += ["finest apart", "limits apart"]
    rows = []
    for name, quantity in finest[0].quantities.items():
        row = [_heading(name, quantity.unit)]
        for run in finest:
            limit = comparison.limits[run.method].get(name)
            row.append(shown(run.quantities[name].value, quantity.unit))
            row.append(ABSENT if limit is None else plus_minus(limit.value, limit.uncertainty, quantity.unit))
        if comparison.differences:
            gap = apart.get(name)
            row += [shown_percent(gap and gap.finest_relative), shown_percent(gap and gap.limit_relative)]
        rows.append(tuple(row))
    return Table("Quantities", tuple(head), tuple(rows), notes)


def references_table(comparison: Comparison) -> Table:
    """Our values next to values from elsewhere."""
    head = ("quantity", "run", "value", "reference", "off by", "limit off by", "source")
    rows = []
    for check in comparison.references:
        reference, unit = check.reference, check.unit
        span = shown(reference.low, unit)
        if reference.high != reference.low:
            span += f" … {shown(reference.high, unit)}"
        end = reference.high if check.limit_outside > 0.0 else reference.low
        rows.append(
            (
                shown_name(reference.quantity),
                check.run,
                with_unit(check.value, unit),
                f"{span} {shown_unit(unit)}",
                shown_percent(check.outside_relative),
                shown_percent(check.limit_outside / end),
                reference.source + (f", wall {reference.wall}" if reference.wall else ""),
            )
        )
    return Table("Against values from elsewhere", head, tuple(rows))


def cost_table(comparison: Comparison, notes: str) -> Table:
    """What every run cost."""
    head = (
        "run",
        "points",
        "steps",
        "total [s]",
        "compile [s]",
        "stepping [s]",
        "processor [s]",
        "per point and step [ns]",
        "memory [MiB]",
    )
    rows = []
    for run in comparison.runs:
        cost = run.cost
        times = (cost.wall_s, cost.compile_s, cost.stepping_s, cost.cpu_s)
        memory = round(cost.peak_memory_bytes / 2**20)
        rows.append(
            (
                run.label,
                run.points,
                cost.steps,
                *(number(time, 3) for time in times),
                _nanoseconds(run),
                memory,
            )
        )
    return Table("Cost", head, tuple(rows), notes)


def ledger_table(comparison: Comparison, notes: str) -> Table:
    """Where the energy went in every completed run, and how well mass, momentum and energy close."""
    complete = [run for run in comparison.runs if run.failure is None]
    names = [name for name in ENERGIES if any(run.energies[name] for run in complete)]
    rows = tuple(
        (
            run.label,
            *(number(run.energies[name], 4) for name in (*names, "initial")),
            f"{100.0 * run.conservation['energy']:.3f} %",
            f"{run.conservation['momentum']:.1e}",
            f"{run.conservation['mass']:.1e}",
        )
        for run in complete
    )
    head = ("run", *names, "initial", "energy error", "momentum error", "mass error")
    return Table("Energy", head, rows, notes)


def effects_table(comparison: Comparison) -> Table:
    """What was simulated and what was not, and why."""
    effects = scene_effects(comparison.scene, comparison.wall, tuple(comparison.methods))
    rows = tuple((each.name, "on" if each.on else "off", each.reason) for each in effects)
    return Table("What was simulated, and what was not", ("effect", "", "why"), rows)


def quantity_notes(comparison: Comparison) -> list[str]:
    """How the final length was taken, how far it swings, and why a quantity is missing."""
    finest = comparison.finest
    told = [f"Final length: {finest[0].quantities['final_length'].note}"]
    for run in finest:
        amplitude = run.quantities["final_length"].more.get("amplitude")
        if amplitude is not None:
            told.append(f"{find_method(run.method).label} swings by ±{with_unit(amplitude, 'm', 2)} in it")
    missing = [
        (name, quantity.note) for name, quantity in finest[0].quantities.items() if quantity.value is None
    ]
    return ["; ".join(told) + "."] + [f"{shown_title(name)}: {note}." for name, note in missing]


def _heading(name: str, unit: str) -> str:
    shown = shown_unit(unit)
    return shown_name(name) + (f" [{shown}]" if shown else "")


def _nanoseconds(run: RunResult) -> str:
    stepping = run.cost.stepping_s - run.cost.compile_s
    if not run.cost.point_updates or stepping <= 0.0:
        return ABSENT
    return number(1e9 * stepping / run.cost.point_updates, 3)

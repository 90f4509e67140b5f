"""The report's tables."""

from html import escape

from studies.comparison import Comparison
from studies.display import (
    number,
    plus_minus,
    shown,
    shown_name,
    shown_percent,
    shown_title,
    shown_unit,
    with_unit,
)
from studies.effects import scene_effects
from studies.history import ENERGIES
from studies.methods import find_method
from studies.report.markup import table
from studies.run_result import RunResult


def quantities_table(comparison: Comparison) -> str:
    """Every quantity: finest value and limit of each method, the difference."""
    finest = comparison.finest
    head = ["Quantity"]
    for run in finest:
        head += [_tag(run, f"{find_method(run.method).label} {run.resolution}"), _tag(run, "limit")]
    apart = {difference.quantity: difference for difference in comparison.differences}
    if comparison.differences:
        head += ["difference<br>of finest", "of limits"]
    rows = []
    for name, quantity in finest[0].quantities.items():
        row = [_heading(name, quantity.unit)]
        for run in finest:
            limit = comparison.limits[run.method].get(name)
            row.append(shown(run.quantities[name].value, quantity.unit))
            row.append(_limit(limit, quantity.unit))
        if comparison.differences:
            gap = apart.get(name)
            row += [shown_percent(gap and gap.finest_relative), shown_percent(gap and gap.limit_relative)]
        rows.append(row)
    return table(head, rows)


def references_table(comparison: Comparison) -> str:
    """Our values next to values from elsewhere."""
    head = ["Quantity", "run", "value", "reference", "off by", "limit off by", "source"]
    rows = []
    for check in comparison.references:
        reference, unit = check.reference, check.unit
        span = shown(reference.low, unit)
        if reference.high != reference.low:
            span += f" … {shown(reference.high, unit)}"
        end = reference.high if check.limit_outside > 0.0 else reference.low
        rows.append(
            [
                shown_name(reference.quantity),
                check.run,
                with_unit(check.value, unit),
                f"{span} {shown_unit(unit)}",
                shown_percent(check.outside_relative),
                shown_percent(check.limit_outside / end),
                escape(reference.source + (f", wall {reference.wall}" if reference.wall else "")),
            ]
        )
    return table(head, rows, words=(6,)) if rows else ""


def cost_table(comparison: Comparison) -> str:
    """What every run cost."""
    head = [
        "Run",
        "points",
        "steps",
        "total s",
        "compile s",
        "stepping s",
        "processor s",
        "ns / point / step",
        "MiB",
    ]
    rows = []
    for run in comparison.runs:
        cost = run.cost
        rows.append(
            [
                _tag(run, run.label),
                f"{run.points:,}",
                f"{cost.steps:,}",
                number(cost.wall_s, 3),
                number(cost.compile_s, 3),
                number(cost.stepping_s, 3),
                number(cost.cpu_s, 3),
                _nanoseconds(run),
                f"{cost.peak_memory_bytes / 2**20:.0f}",
            ]
        )
    return table(head, rows)


def ledger_table(comparison: Comparison) -> str:
    """Where the energy went in every completed run, and how well mass, momentum and energy close."""
    complete = [run for run in comparison.runs if run.failure is None]
    shown = [name for name in ENERGIES if any(run.energies[name] for run in complete)]
    head = [
        "Run",
        *shown,
        "initial",
        "energy",
        "momentum",
        "mass",
    ]
    rows = [
        [
            _tag(run, run.label),
            *(number(run.energies[name], 4) for name in (*shown, "initial")),
            f"{100.0 * run.conservation['energy']:.3f} %",
            f"{run.conservation['momentum']:.1e}",
            f"{run.conservation['mass']:.1e}",
        ]
        for run in complete
    ]
    return table(head, rows) if rows else ""


def effects_table(comparison: Comparison) -> str:
    """What was simulated and what was not, and why."""
    effects = scene_effects(comparison.scene, comparison.wall, tuple(comparison.methods))
    marks = {True: '<span class="on">on</span>', False: '<span class="off">off</span>'}
    return table(
        ["Effect", "", "why"], [[escape(e.name), marks[e.on], escape(e.reason)] for e in effects], words=(2,)
    )


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
    return shown_name(name) + (f' <span class="note">{shown}</span>' if shown else "")


def _limit(limit, unit: str) -> str:
    return "–" if limit is None else plus_minus(limit.value, limit.uncertainty, unit)


def _nanoseconds(run: RunResult) -> str:
    stepping = run.cost.stepping_s - run.cost.compile_s
    return (
        number(1e9 * stepping / run.cost.point_updates, 3)
        if run.cost.point_updates and stepping > 0.0
        else "–"
    )


def _tag(run: RunResult, text: str) -> str:
    return f'<span class="{find_method(run.method).scene_key}">{escape(text)}</span>'

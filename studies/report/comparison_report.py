"""The report of a comparison: verdicts, shapes, quantities, convergence, histories, energies, costs."""

from concurrent.futures import ThreadPoolExecutor

from core_models.walls import MEANING
from studies.bar.quantity_names import LEADING
from studies.comparisons.comparison import Comparison
from studies.methods.method import find_method
from studies.report.comparison_data import energy_data, quantity_data
from studies.report.comparison_tables import (
    cost_table,
    effects_table,
    ledger_table,
    quantities_table,
    quantity_notes,
    references_table,
)
from studies.report.convergence_plots import convergence_plots
from studies.report.difference_maps import difference_maps, difference_table
from studies.report.field_pictures import field_pictures
from studies.report.history_plots import energy_plots, history_plots
from studies.report.over_time import OverTime, over_time
from studies.report.profile_plots import profile_plots
from studies.report.study_page import AGREE, APART, NEUTRAL, TOLD, Report, Section, Verdict

LEDGER = (
    "Energies in J; each dissipative term is integrated from its own power, none is the remainder. "
    "Strain holds all that the stress stores, the thermal part of the equation of state's energy too, and may "
    "be negative. The last three columns are relative errors of the balances."
)
COST = (
    "Total counts everything: mesh, compilation, steps, output. Compilation is zero once the kernels are "
    "on disk. ns per point and step: stepping without compilation and output."
)
LIMIT = "Limit: extrapolated to infinite resolution by least squares of f₀ + a hᵖ, with its uncertainty."


def report_of(comparison: Comparison, *, moving: bool = True) -> Report:
    """The whole report, with pictures over time if `moving`; raises UnsupportedError when matplotlib is missing."""
    scene, bar = comparison.scene, comparison.scene.bar
    laws = (scene.material.update, scene.material.flow, scene.material.eos)
    return Report(
        title=f"{scene.name}, wall {comparison.wall}",
        lead=scene.description,
        facts=(
            f"wall: {comparison.wall}",
            f"L₀ {bar.length * 1e3:g} mm",
            f"R₀ {bar.radius * 1e3:g} mm",
            f"{-bar.velocity:g} m/s",
            f"{bar.temperature:g} K",
            *(type(law).__name__ for law in laws if law is not None),
        ),
        sections=(*(_results(comparison, moving) if comparison.finest else ()), *_accounts(comparison)),
        warnings=tuple(f"{run.label}: {run.failure}" for run in comparison.failed),
        footnotes=tuple(_footnotes(comparison)),
    )


def _results(comparison: Comparison, moving: bool) -> tuple[Section, ...]:
    with ThreadPoolExecutor(1) as pool:
        # A process of its own draws what moves: meanwhile this one draws the rest.
        frames = pool.submit(over_time, comparison) if moving else None
        short, shapes, *others = _still(comparison)
        moved = _moving(frames.result() if frames else OverTime())
    return (short, shapes, moved, *others)


def _moving(frames: OverTime) -> Section:
    return Section(
        "time",
        "Over time",
        remarks=(frames.remark,) if frames.remark else (),
        controls=frames.player,
        figures=frames.figures,
        caption=frames.caption,
    )


def _still(comparison: Comparison) -> tuple[Section, ...]:
    wall = f"Wall {comparison.wall}: {MEANING[comparison.wall]}."
    profiles = f"Edges of the deformed domains, their feet set on z = 0; coarser runs thin. {wall}"
    convergence = (
        "N: elements or cells across the radius. Diamonds: limits with their uncertainty; "
        f"grey: values from elsewhere. {wall}"
    )
    heights = "Heights count from the foot: the median over the inner half of its radius."
    notes = " ".join([LIMIT, heights, *quantity_notes(comparison)])
    return (
        Section("short", "In short", verdicts=tuple(_verdicts(comparison))),
        Section(
            "shapes", "Final shapes", figures=tuple(field_pictures(comparison)), caption=_ends(comparison)
        ),
        Section("profiles", "Profiles", figures=tuple(profile_plots(comparison)), caption=profiles),
        Section(
            "quantities",
            "Quantities",
            (quantities_table(comparison, notes),),
            data=(quantity_data(comparison),),
        ),
        Section(
            "differences",
            "Difference of the final fields",
            (difference_table(comparison),),
            figures=tuple(difference_maps(comparison)),
        ),
        Section("references", "Against values from elsewhere", (references_table(comparison),)),
        Section(
            "convergence", "Convergence", figures=tuple(convergence_plots(comparison)), caption=convergence
        ),
        Section("histories", "Histories", figures=tuple(history_plots(comparison)), caption=wall),
    )


def _accounts(comparison: Comparison) -> tuple[Section, ...]:
    return (
        Section(
            "energies",
            "Energy",
            (ledger_table(comparison, LEDGER),),
            figures=tuple(energy_plots(comparison)),
            data=(energy_data(comparison),),
        ),
        Section("costs", "Cost", (cost_table(comparison, COST),)),
        Section("effects", "What was simulated, and what was not", (effects_table(comparison),)),
    )


def _verdicts(comparison: Comparison) -> list[Verdict]:
    kinds = {True: AGREE, False: APART, None: NEUTRAL}
    told = [
        Verdict(NEUTRAL if each.loosely else kinds[each.agree], each.verdict)
        for each in comparison.differences
        if each.quantity in LEADING
    ]
    return told + [
        Verdict(
            TOLD,
            f"Profiles: {gap.first} and {gap.second} lie {gap.rms * 1e3:.3g} mm apart (root mean square), "
            f"{100.0 * gap.relative:.2g} % of L₀.",
        )
        for gap in comparison.profiles
    ]


def _ends(comparison: Comparison) -> str:
    return "; ".join(
        f"{find_method(run.method).label} {run.resolution} ended {run.ended}" for run in comparison.finest
    )


def _footnotes(comparison: Comparison) -> list[str]:
    threads = ", ".join(map(str, sorted({run.threads for run in comparison.runs})))
    told = [f"threads: {threads}. Numbers in full: results.json beside this page."]
    if comparison.scene.unused:
        told.insert(0, f"Tags of the card that do nothing: {'; '.join(comparison.scene.unused)}")
    return told

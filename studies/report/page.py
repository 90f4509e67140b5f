"""The report as one self-contained HTML page."""

from html import escape
from importlib.resources import files

from core_models.walls import MEANING
from studies.comparison import Comparison
from studies.methods import find_method
from studies.quantity_names import LEADING
from studies.report.convergence_plots import convergence_plots
from studies.report.difference_pictures import difference_pictures
from studies.report.field_pictures import field_pictures
from studies.report.history_plots import energy_plots, history_plots
from studies.report.markup import items, note, panels, section
from studies.report.page_tables import (
    cost_table,
    effects_table,
    ledger_table,
    quantities_table,
    quantity_notes,
    references_table,
)
from studies.report.profile_plots import profile_plots
from studies.versions import processor, versions


def report_page(comparison: Comparison) -> str:
    """The page; raises UnsupportedError when matplotlib is missing."""
    style = files("studies.report").joinpath("style.css").read_text(encoding="utf-8")
    title = escape(f"{comparison.scene.name}, wall {comparison.wall}")
    body = "".join([_head(comparison), _failures(comparison), *_results(comparison), *_accounts(comparison)])
    return (
        '<!doctype html><html lang="en"><head><meta charset="utf-8">'
        '<meta name="viewport" content="width=device-width, initial-scale=1">'
        f"<title>{title}</title><style>{style}</style></head><body>{body}{_foot(comparison)}</body></html>\n"
    )


def _head(comparison: Comparison) -> str:
    scene, bar = comparison.scene, comparison.scene.bar
    facts = [
        f"wall: {comparison.wall}",
        f"L₀ {bar.length * 1e3:g} mm",
        f"R₀ {bar.radius * 1e3:g} mm",
        f"{-bar.velocity:g} m/s",
        f"{bar.temperature:g} K",
        f"{type(scene.material.update).__name__}",
        *(type(law).__name__ for law in (scene.material.flow, scene.material.eos) if law is not None),
    ]
    return (
        f'<header><h1>{escape(scene.name)}</h1><p class="lead">{escape(scene.description)}</p>'
        + items("facts", [("", fact) for fact in facts])
        + "</header>"
    )


def _failures(comparison: Comparison) -> str:
    told = "".join(
        f"<p><b>{escape(run.label)}</b>: {escape(str(run.failure))}</p>" for run in comparison.failed
    )
    return f'<div class="warning"><b>Runs that went wrong</b>{told}</div>' if told else ""


def _results(comparison: Comparison) -> list[str]:
    if not comparison.finest:
        return []
    wall = f"Wall {comparison.wall}: {MEANING[comparison.wall]}."
    profiles = f"Edges of the deformed domains, their feet set on z = 0; coarser runs thin. {wall}"
    convergence = (
        "N: elements or cells across the radius. Diamonds: limits with their uncertainty; "
        f"grey: values from elsewhere. {wall}"
    )
    return [
        section("In short", _verdicts(comparison)),
        section("Final shapes", panels(field_pictures(comparison), _ends(comparison))),
        section("Where the methods differ", panels(difference_pictures(comparison), _map_note(comparison))),
        section("Profiles", panels(profile_plots(comparison), profiles)),
        section("Quantities", quantities_table(comparison), note(_limits_note(comparison))),
        section("Against values from elsewhere", references_table(comparison)),
        section("Convergence", panels(convergence_plots(comparison), convergence)),
        section("Histories", panels(history_plots(comparison), wall)),
    ]


def _map_note(comparison: Comparison) -> str:
    if comparison.map is None:
        return ""
    moved = comparison.map.summary()["displacement"]
    return (
        f"Means over the cells of one mesh of the undeformed bar. Displacements differ by {1e3 * moved['rms']:.3g} mm "
        f"(root mean square), at most {1e3 * moved['largest']:.3g} mm. Wall {comparison.wall}."
    )


def _accounts(comparison: Comparison) -> list[str]:
    ledger = (
        "Energies in J; each dissipative term is integrated from its own power, none is the remainder. "
        "Strain holds all that the stress stores, the thermal part of the equation of state's energy too, and may "
        "be negative. The last three columns are relative errors of the balances."
    )
    cost = (
        "Total counts everything: mesh, compilation, steps, output. Compilation is zero once the kernels are "
        "on disk. ns per point and step: stepping without compilation and output."
    )
    return [
        section("Energy", panels(energy_plots(comparison), ledger), ledger_table(comparison)),
        section("Cost", cost_table(comparison), note(cost)),
        section("What was simulated, and what was not", effects_table(comparison)),
    ]


def _verdicts(comparison: Comparison) -> str:
    kinds = {True: "agree", False: "apart", None: ""}
    entries = [
        (kinds[each.agree], each.verdict) for each in comparison.differences if each.quantity in LEADING
    ]
    entries += [
        (
            "",
            f"Profiles: {gap.first} and {gap.second} lie {gap.rms * 1e3:.3g} mm apart (root mean square), "
            f"{100.0 * gap.relative:.2g} % of L₀.",
        )
        for gap in comparison.profiles
    ]
    return items("verdicts", entries) if entries else ""


def _ends(comparison: Comparison) -> str:
    return "; ".join(
        f"{find_method(run.method).label} {run.resolution} ended {run.ended}" for run in comparison.finest
    )


def _limits_note(comparison: Comparison) -> str:
    return " ".join(
        [
            "Limit: extrapolated to infinite resolution by least squares of f₀ + a hᵖ, with its uncertainty.",
            "Heights count from the foot: the median over the inner half of its radius.",
            *quantity_notes(comparison),
        ]
    )


def _foot(comparison: Comparison) -> str:
    made = ", ".join(f"{name} {version}" for name, version in versions().items())
    threads = sorted({run.threads for run in comparison.runs})
    unused = "; ".join(comparison.scene.unused)
    ignored = f"<p>Tags of the card that do nothing: {escape(unused)}</p>" if unused else ""
    return (
        f"<footer>{ignored}<p>{escape(made)}</p><p>{escape(processor())}; threads: "
        f"{', '.join(map(str, threads))}. Numbers in full: results.json beside this page.</p></footer>"
    )

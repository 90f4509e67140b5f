"""Quantities against resolution, with the extrapolated limits and references."""

import numpy as np

from studies.comparisons.comparison import Comparison
from studies.methods.method import find_method
from studies.output.display import SHOWN_UNITS, shown_name, shown_title
from studies.report.drawing import FAINT, as_svg, colour_of, drawing

SHOWN = ("final_length", "foot_radius", "max_equivalent_plastic_strain", "max_temperature")


def convergence_plots(comparison: Comparison) -> list[str]:
    """One panel per leading quantity: values over 1/N, limit with its uncertainty at zero."""
    names = [name for name in SHOWN if any(name in of for of in comparison.limits.values())]
    return [_panel(name, comparison) for name in names]


def _panel(name: str, comparison: Comparison) -> str:
    with drawing() as (figure, ax):
        _show(ax, name, comparison)
        ax.legend()
        return as_svg(figure, f"convergence-{name}", f"{shown_name(name)} against resolution")


def _show(ax, name: str, comparison: Comparison) -> None:
    for method, limits in comparison.limits.items():
        if name in limits:
            _sequence(ax, name, method, comparison)
    unit = comparison.finest[0].quantities[name].unit
    scale, shown = SHOWN_UNITS[unit]
    for check in comparison.references:
        if check.reference.quantity == name:
            low, high = check.reference.low * scale, check.reference.high * scale
            ax.axhspan(low, high, color=FAINT, alpha=0.35, linewidth=1.0)
    title = shown_title(name).replace("Max ", "Largest ")
    ax.set(title=f"{title} [{shown}]" if shown else title, xlabel=f"1 / N, wall {comparison.wall}")
    ax.set_xlim(left=-0.004)


def _sequence(ax, name: str, method: str, comparison: Comparison) -> None:
    runs = comparison.complete(method)
    scale = SHOWN_UNITS[runs[0].quantities[name].unit][0]
    limit, colour = comparison.limits[method][name], colour_of(method)
    h = np.array([1.0 / run.resolution for run in runs])
    values = np.array([run.quantities[name].value for run in runs]) * scale
    ax.plot(h, values, "o-", color=colour, markersize=4, linewidth=1.0, label=find_method(method).label)
    if limit.uncertainty is not None:
        ax.errorbar(
            [0.0],
            [limit.value * scale],
            [limit.uncertainty * scale],
            fmt="D",
            color=colour,
            markersize=4,
            capsize=4,
        )

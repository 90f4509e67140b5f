"""Histories: length, foot radius, energies, wall force."""

import numpy as np

from studies.comparisons.comparison import Comparison
from studies.methods.method import find_method
from studies.observers.history import ENERGIES
from studies.report.drawing import INK, as_svg, colour_of, drawing, line_of
from studies.runs.result import RunResult
from studies.scenes.curves import COLUMNS, read_curve

MICROSECONDS = 1e6
ENERGY_COLOURS = ("#3b7dd8", "#2a9d8f", "#c8553d", "#9467bd", "#b8860b", "#8c8c8c", "#d18cc0", "#6b8e23")


PANELS = (
    ("length", "Length [mm]", 1e3),
    ("foot_radius", "Foot radius [mm]", 1e3),
    ("wall_force", "Wall force [kN]", 1e-3),
    ("rim_lift", "Rim lift [mm]", 1e3),
)


def history_plots(comparison: Comparison) -> list[str]:
    """Length, foot radius, mean wall force and rim lift of the finest runs over time."""
    return [_history(comparison, *panel) for panel in PANELS]


def energy_plots(comparison: Comparison) -> list[str]:
    """Where the energy is over time, one panel per method."""
    return [_energies(run) for run in comparison.finest]


def _history(comparison: Comparison, column: str, title: str, scale: float) -> str:
    with drawing() as (figure, ax):
        _over_time(ax, comparison, column, scale)
        _reference(ax, comparison, column, scale)
        ax.set_title(f"{title}, wall {comparison.wall}")
        ax.legend()
        return as_svg(figure, column, f"{title} over time")


def _energies(run: RunResult) -> str:
    with drawing() as (figure, ax):
        t = run.history.column("t") * MICROSECONDS
        for name, colour in zip(ENERGIES, ENERGY_COLOURS, strict=True):
            values = run.history.column(name)
            if values.any():
                ax.plot(t, values, color=colour, label=name)
        ax.plot(t, run.history.column("total"), color=INK, linewidth=1.0, linestyle=":", label="total")
        ax.set(title=f"Energy [J], {find_method(run.method).label} {run.resolution}, wall {run.wall}")
        ax.set(xlabel="t [µs]", xlim=(0.0, t[-1]))
        ax.legend(loc="center right")
        return as_svg(figure, f"energy-{run.method}", f"Energies of {run.label} over time")


def _over_time(ax, comparison: Comparison, column: str, scale: float) -> None:
    for run in comparison.finest:
        t, values = run.history.column("t") * MICROSECONDS, run.history.column(column) * scale
        label = f"{find_method(run.method).label} {run.resolution}"
        style = line_of(run.method, comparison.methods)
        ax.plot(t, values, color=colour_of(run.method), linestyle=style, label=label)
    ax.set(xlabel="t [µs]")
    ax.set_xlim(left=0.0)


def _reference(ax, comparison: Comparison, column: str, scale: float) -> None:
    for curve in comparison.scene.curves:
        if curve.kind == "history" and column in COLUMNS["history"] and curve.wall in (None, comparison.wall):
            data = read_curve(curve)
            t = np.asarray(data["t"]) * MICROSECONDS
            ax.plot(t, data[column] * scale, "o", color=INK, markersize=3, label="reference")

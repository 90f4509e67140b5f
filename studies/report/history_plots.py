"""Histories: length, foot radius, energies, wall force."""

import numpy as np

from studies.comparison import Comparison
from studies.curves import read_curve
from studies.history import ENERGIES
from studies.methods import METHODS
from studies.report.drawing import INK, METHOD_COLOURS, as_svg, drawing
from studies.report.profile_plots import STYLES

MICROSECONDS = 1e6
ENERGY_COLOURS = ("#3b7dd8", "#2a9d8f", "#c8553d", "#9467bd", "#b8860b", "#8c8c8c")


def history_plots(comparison: Comparison) -> str:
    """Length, foot radius, mean wall force of the finest runs over time."""
    panels = (("length", "Length [mm]", 1e3), ("foot_radius", "Foot radius [mm]", 1e3))
    with drawing(7.4, 5.6, rows=2, columns=2) as (figure, axes):
        for ax, (column, title, scale) in zip(axes[0], panels, strict=True):
            _over_time(ax, comparison, column, scale)
            _reference(ax, comparison, column, scale)
            ax.set_title(f"{title}, wall {comparison.wall}")
        _over_time(axes[1, 0], comparison, "wall_force", 1e-3)
        axes[1, 0].set_title(f"Wall force [kN], wall {comparison.wall}")
        _over_time(axes[1, 1], comparison, "rim_lift", 1e3)
        axes[1, 1].set_title(f"Lift of the foot's rim [mm], wall {comparison.wall}")
        axes[0, 0].legend()
        return as_svg(figure, "histories", "Length, foot radius, wall force and rim lift over time")


def energy_plots(comparison: Comparison) -> str:
    """Where the energy is over time, one panel per method."""
    runs = comparison.finest
    with drawing(7.4, 3.2, columns=len(runs), sharey=True) as (figure, axes):
        for ax, run in zip(axes[0], runs, strict=True):
            t = run.history.column("t") * MICROSECONDS
            for name, colour in zip(ENERGIES, ENERGY_COLOURS, strict=True):
                ax.plot(t, run.history.column(name), color=colour, label=name)
            ax.plot(t, run.history.column("total"), color=INK, linewidth=1.0, linestyle=":", label="total")
            ax.set(title=f"Energy [J], {METHODS[run.method].label} {run.resolution}, wall {run.wall}")
            ax.set(xlabel="t [µs]", xlim=(0.0, t[-1]))
        axes[0, -1].legend(loc="center right")
        return as_svg(figure, "energies", "Energies over time")


def _over_time(ax, comparison: Comparison, column: str, scale: float) -> None:
    for run in comparison.finest:
        t, values = run.history.column("t") * MICROSECONDS, run.history.column(column) * scale
        label = f"{METHODS[run.method].label} {run.resolution}"
        ax.plot(t, values, color=METHOD_COLOURS[run.method], linestyle=STYLES[run.method], label=label)
    ax.set(xlabel="t [µs]")
    ax.set_xlim(left=0.0)


def _reference(ax, comparison: Comparison, column: str, scale: float) -> None:
    for curve in comparison.scene.curves:
        if curve.kind == "history" and curve.wall in (None, comparison.wall):
            data = read_curve(curve)
            t = np.asarray(data["t"]) * MICROSECONDS
            ax.plot(t, data[column] * scale, "o", color=INK, markersize=3, label="reference")

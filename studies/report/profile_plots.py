"""Final profiles laid over each other."""

from collections.abc import Callable

import numpy as np

from studies.bar.shape import standing
from studies.comparisons.comparison import Comparison
from studies.methods.method import find_method
from studies.report.drawing import INK, as_svg, colour_of, drawing, line_of
from studies.scenes.curves import read_curve

MILLIMETRES = 1e3


def profile_plots(comparison: Comparison) -> list[str]:
    """The whole half profiles, and the rim of the foot enlarged; coarser runs are drawn thin."""
    return [
        _profiles(comparison, "Half profiles", _show_all),
        _profiles(comparison, "The foot's rim", _show_rim),
    ]


def _profiles(comparison: Comparison, title: str, show: Callable) -> str:
    with drawing() as (figure, ax):
        _draw(ax, comparison)
        ax.axhline(0.0, color=INK, linewidth=1.4)
        ax.set(xlabel="r [mm]", ylabel="z [mm]", aspect="equal", anchor="W")
        ax.set_title(f"{title}, wall {comparison.wall}")
        show(ax, comparison)
        ax.legend(loc="upper right")
        return as_svg(figure, title, f"{title} of all runs")


def _draw(ax, comparison: Comparison) -> None:
    for run in comparison.finest:
        for coarse in comparison.complete(run.method)[:-1]:
            _line(ax, coarse, comparison, linewidth=0.5, alpha=0.6)
        _line(ax, run, comparison, linewidth=1.7, label=f"{find_method(run.method).label} {run.resolution}")
    for curve in comparison.scene.curves:
        if curve.kind == "profile" and curve.wall in (None, comparison.wall):
            data = read_curve(curve)
            ax.plot(data["r"] * 1e3, data["z"] * 1e3, "o", color=INK, markersize=3, label="reference")


def _line(ax, run, comparison: Comparison, **style) -> None:
    outline = standing(run.final.outline)
    line = np.concatenate([outline[part] for part in ("foot", "side", "rear")]) * MILLIMETRES
    ax.plot(*line.T, color=colour_of(run.method), linestyle=line_of(run.method, comparison.methods), **style)


def _show_all(ax, comparison: Comparison) -> None:
    top = max(run.final.outline["rear"][:, 1].max() for run in comparison.finest) * MILLIMETRES
    ax.set(xlim=(0.0, 1.5 * top), ylim=(-0.03 * top, 1.05 * top))


def _show_rim(ax, comparison: Comparison) -> None:
    radius = max(run.quantities["foot_radius"].value for run in comparison.finest) * MILLIMETRES
    ax.set(xlim=(0.72 * radius, 1.03 * radius), ylim=(-0.01 * radius, 0.2 * radius))

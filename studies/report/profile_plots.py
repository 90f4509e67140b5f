"""Final profiles laid over each other."""

import numpy as np

from studies.bar_shape import standing
from studies.comparison import Comparison
from studies.curves import read_curve
from studies.methods import METHODS
from studies.report.drawing import INK, METHOD_COLOURS, as_svg, drawing

MILLIMETRES = 1e3
STYLES = {"fem-explicit": "-", "mpm": (0, (4, 1.5))}


def profile_plot(comparison: Comparison) -> str:
    """Whole half profiles, and the rim of the foot enlarged; coarser runs are drawn thin."""
    with drawing(7.4, 3.9, columns=2, width_ratios=(1.0, 1.25)) as (figure, axes):
        whole, rim = axes[0]
        for ax in (whole, rim):
            _draw(ax, comparison)
            ax.axhline(0.0, color=INK, linewidth=1.4)
            ax.set(xlabel="r [mm]", ylabel="z [mm]", aspect="equal")
        whole.set_title(f"Half profiles, wall {comparison.wall}")
        whole.set_xlim(left=0.0)
        _enlarge(rim, comparison)
        rim.legend(loc="upper right")
        return as_svg(figure, "profiles", "Final half profiles of all runs")


def _draw(ax, comparison: Comparison) -> None:
    for run in comparison.finest:
        for coarse in comparison.complete(run.method)[:-1]:
            _line(ax, coarse, linewidth=0.5, alpha=0.6)
        _line(ax, run, linewidth=1.7, label=f"{METHODS[run.method].label} {run.resolution}")
    for curve in comparison.scene.curves:
        if curve.kind == "profile" and curve.wall in (None, comparison.wall):
            data = read_curve(curve)
            ax.plot(data["r"] * 1e3, data["z"] * 1e3, "o", color=INK, markersize=3, label="reference")


def _line(ax, run, **style) -> None:
    outline = standing(run.final.outline)
    line = np.concatenate([outline[part] for part in ("foot", "side", "rear")]) * MILLIMETRES
    ax.plot(*line.T, color=METHOD_COLOURS[run.method], linestyle=STYLES[run.method], **style)


def _enlarge(ax, comparison: Comparison) -> None:
    radius = max(run.quantities["foot_radius"].value for run in comparison.finest) * MILLIMETRES
    ax.set_title("The foot's rim")
    ax.set(xlim=(0.72 * radius, 1.03 * radius), ylim=(-0.01 * radius, 0.21 * radius))

"""Figures of the verification report."""

from itertools import cycle

from studies.report.drawing import INK, METHOD_COLOURS, as_svg, drawing
from studies.verification.outcome import Curve, Plot
from studies.verification.variant import FEM, MPM

COLOURS = {FEM: METHOD_COLOURS["fem-explicit"], MPM: METHOD_COLOURS["mpm"], "exact": INK}
MARKERS = ("o", "s", "^", "D", "v", "P", "X", "<", ">", "*", "h", "p")
LINES = ("-", (0, (5, 1.5)), (0, (1.5, 1.2)), (0, (5, 1.2, 1.2, 1.2)))
MANY = 15  # values of a curve above which they are not marked one by one
SIZE = 4.6, 3.6  # inches


def plot_svg(plot: Plot, problem: str) -> str:
    """One figure as an SVG element that follows the page's colours."""
    with drawing(*SIZE) as (figure, ax):
        markers, lines = cycle(MARKERS), {family: cycle(LINES) for family in COLOURS}
        for curve in plot.curves:
            ax.plot(curve.x, curve.y, **_style(curve, markers, lines))
        if plot.logarithmic:
            ax.set(xscale="log", yscale="log")
        ax.set(title=plot.title, xlabel=plot.x_label, ylabel=plot.y_label)
        ax.legend(fontsize=7.5, ncols=1 + (len(plot.curves) > 6))
        return as_svg(figure, f"{problem}-{plot.title}", f"{plot.title}: {plot.y_label} over {plot.x_label}")


def _style(curve: Curve, markers, lines) -> dict:
    exact = curve.family == "exact"
    style = {"label": curve.label, "color": COLOURS[curve.family], "linewidth": 1.0}
    if exact:
        return style | {"linestyle": "--"}
    style["linestyle"] = next(lines[curve.family])
    return style if len(curve.x) > MANY else style | {"marker": next(markers), "markersize": 3.5}

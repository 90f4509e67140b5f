"""Plots and pictures of a report as SVG."""

from itertools import cycle

import numpy as np

from studies.report.drawing import INK, METHOD_COLOURS, as_svg, drawing
from studies.report.log_ticks import set_log_ticks
from studies.report.parts import EXACT, FEM, MPM, Curve, Picture, Plot

COLOURS = {FEM: METHOD_COLOURS["fem-explicit"], MPM: METHOD_COLOURS["mpm"], EXACT: INK}
MARKERS = ("o", "s", "^", "D", "v", "P", "X", "<", ">", "*", "h", "p")
LINES = ("-", (0, (5, 1.5)), (0, (1.5, 1.2)), (0, (5, 1.2, 1.2, 1.2)))
MANY = 15  # values of a curve above which they are not marked one by one
SIZE = 4.6, 3.6  # inches
MOST_LETTERS = 90  # of all labels, beyond which the legend stands below the axes
LEGEND_ROW = 0.17  # inches
PANEL, TALLEST = 3.0, 4.0  # inches, of one body in a picture: width, and height of an upright one


def plot_svg(plot: Plot, problem: str) -> str:
    """One figure as an SVG element that follows the page's colours."""
    longest = max(len(curve.label) for curve in plot.curves)
    beside = len(plot.curves) * longest > MOST_LETTERS
    width, height = SIZE
    with drawing(width, height + beside * LEGEND_ROW * len(plot.curves)) as (figure, ax):
        markers, lines = cycle(MARKERS), {family: cycle(LINES) for family in COLOURS}
        for curve in plot.curves:
            ax.plot(curve.x, curve.y, **_style(curve, markers, lines, plot.scattered))
        if plot.logarithmic:
            ax.set(xscale="log", yscale="log")
            set_log_ticks(ax.xaxis)
            set_log_ticks(ax.yaxis)
        ax.set(title=plot.title, xlabel=plot.x_label, ylabel=plot.y_label)
        if beside:
            figure.legend(fontsize=7.5, loc="outside lower left")
        else:
            ax.legend(fontsize=7.5, ncols=1 + (len(plot.curves) > 6))
        return as_svg(figure, f"{problem}-{plot.title}", f"{plot.title}: {plot.y_label} over {plot.x_label}")


def picture_svg(picture: Picture, problem: str) -> str:
    """The deformed bodies side by side, coloured by the field, as an SVG element that follows the page's colours."""
    from matplotlib.collections import PolyCollection

    domains = np.concatenate([each for each, _values in picture.panels.values()])
    low, high = domains.reshape(-1, 2).min(axis=0), domains.reshape(-1, 2).max(axis=0)
    wide, tall = high - low
    count = len(picture.panels)
    is_upright = tall > wide
    height = min(PANEL * tall / wide, TALLEST) if is_upright else PANEL * tall / wide * (count + 0.35)
    with drawing(PANEL * (count + 0.3) if is_upright else PANEL + 1.0, height + 0.9) as (figure, first):
        first.remove()
        shape = (1, count) if is_upright else (count, 1)
        axes = figure.subplots(*shape, squeeze=False, sharex=True, sharey=True).ravel()
        limits = picture.limits or _range(picture)
        for ax, (name, (cells, values)) in zip(axes, picture.panels.items(), strict=True):
            drawn = PolyCollection(
                cells,
                array=values,
                cmap="viridis",
                clim=limits,
                linewidths=0.0,
                antialiased=False,
                rasterized=True,
            )
            ax.add_collection(drawn)
            ax.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), aspect="equal")
            ax.set_title(name, fontsize=9, fontweight="normal")
            ax.grid(visible=False)
        bar = figure.colorbar(drawn, ax=axes.tolist(), shrink=0.8, label=picture.label)
        bar.outline.set_visible(False)
        return as_svg(figure, f"{problem}-{picture.title}", f"{picture.title}: {picture.label}")


def _range(picture: Picture) -> tuple[float, float]:
    values = np.concatenate([each for _domains, each in picture.panels.values()])
    return float(values.min()), float(values.max())


def _style(curve: Curve, markers, lines, scattered: bool) -> dict:
    style = {"label": curve.label, "color": COLOURS[curve.family], "linewidth": 1.0}
    if scattered:
        return style | {"linestyle": "", "marker": next(markers), "markersize": 4.0, "fillstyle": "none"}
    if curve.family == EXACT:
        return style | {"linestyle": "--"}
    style["linestyle"] = next(lines[curve.family])
    return style if len(curve.x) > MANY else style | {"marker": next(markers), "markersize": 3.5}

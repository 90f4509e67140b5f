"""Drawing final shapes coloured by a field, to the left or right of the axis."""

import numpy as np

from studies.report.drawing import FAINT, INK
from studies.runs.result import RunResult

MILLIMETRES = 1e3
WIDTH = 5.2  # inches, of the figure; SCALE: of half the picture's width
SCALE = 1.95
LEFT, RIGHT = -1.0, 1.0


def extent(runs: list[RunResult]) -> tuple[float, float]:
    """Half width and height of the picture [mm], with room for names above the shapes."""
    radius = max(run.final.outline["side"][:, 0].max() for run in runs) * MILLIMETRES
    height = max(run.final.outline["rear"][:, 1].max() for run in runs) * MILLIMETRES
    return max(1.1 * radius, 0.6 * height), 1.27 * height


def size(half_width: float, top: float) -> tuple[float, float]:
    """Width and height of a figure of that extent [inches]."""
    return WIDTH, SCALE * top / half_width + 0.9


def draw_half(ax, run: RunResult, values: np.ndarray, side: float, colours: str, limits: tuple[float, float]):
    """Draw a run's domains, coloured by values (n,), and its outline on one side; returns what a colour bar needs."""
    from matplotlib.collections import PolyCollection

    to_picture = [side * MILLIMETRES, MILLIMETRES]
    drawn = PolyCollection(
        run.final.domains * to_picture,
        array=values,
        cmap=colours,
        clim=limits,
        linewidths=0.0,
        antialiased=False,
        rasterized=True,
    )
    ax.add_collection(drawn)
    line = np.concatenate([run.final.outline[part] for part in ("foot", "side", "rear")])
    ax.plot(*(line * to_picture).T, color=INK, linewidth=0.7)
    return drawn


def finish(figure, ax, drawn, half_width: float, top: float, title: str, extend: str = "neither") -> None:
    """Axis, wall, limits, colour bar, title."""
    ax.axvline(0.0, color=FAINT, linewidth=0.6)
    ax.axhline(0.0, color=INK, linewidth=1.4)
    ax.set(xlabel="r [mm]", ylabel="z [mm]", aspect="equal")
    ax.set(xlim=(-half_width, half_width), ylim=(-0.03 * top, top))
    ax.xaxis.set_major_formatter(lambda value, _: f"{abs(value):g}")
    ax.grid(visible=False)
    bar = figure.colorbar(drawn, ax=ax, shrink=0.85, pad=0.02, extend=extend)
    bar.outline.set_visible(False)
    figure.suptitle(title, x=0.01, ha="left", fontsize=10.5, fontweight="bold")

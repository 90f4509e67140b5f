"""Final shapes side by side, coloured by a field: one method left of the axis, the other right."""

import numpy as np

from studies.comparison import Comparison
from studies.methods import find_method
from studies.report.drawing import FAINT, INK, as_svg, drawing
from studies.run_result import RunResult

FIELDS = {
    "equivalent_plastic_strain": ("Equivalent plastic strain", "viridis"),
    "temperature": ("Temperature [K]", "inferno"),
    "damage": ("Johnson-Cook damage", "cividis"),
}
MILLIMETRES = 1e3
WIDTH = 5.2  # inches, of the figure; SCALE: of half the picture's width
SCALE = 1.95


def field_pictures(comparison: Comparison) -> list[str]:
    """One picture per field that the finest runs have and that varies."""
    runs = comparison.finest
    shown = [name for name in FIELDS if all(name in run.final.fields for run in runs)]
    return [
        _picture(name, runs, comparison.wall)
        for name in shown
        if _range(name, runs)[1] > _range(name, runs)[0]
    ]


def _range(name: str, runs: list[RunResult]) -> tuple[float, float]:
    values = [run.final.fields[name] for run in runs]
    return min(float(v.min()) for v in values), max(float(v.max()) for v in values)


def _picture(name: str, runs: list[RunResult], wall: str) -> str:
    from matplotlib.collections import PolyCollection

    title, colours = FIELDS[name]
    half_width, top = _extent(runs)
    with drawing(WIDTH, SCALE * top / half_width + 0.9) as (figure, ax):
        lowest, highest = _range(name, runs)
        for run, side in ((runs[0], -1.0), (runs[-1], 1.0)):
            drawn = PolyCollection(
                run.final.domains * [side * MILLIMETRES, MILLIMETRES],
                array=run.final.fields[name],
                cmap=colours,
                clim=(lowest, highest),
                linewidths=0.0,
                antialiased=False,
                rasterized=True,
            )
            ax.add_collection(drawn)
            _outline(ax, run, side)
            _name(ax, run, side)
        ax.axvline(0.0, color=FAINT, linewidth=0.6)
        ax.axhline(0.0, color=INK, linewidth=1.4)
        ax.set(xlabel="r [mm]", ylabel="z [mm]", aspect="equal")
        ax.set(xlim=(-half_width, half_width), ylim=(-0.03 * top, top))
        ax.xaxis.set_major_formatter(lambda value, _: f"{abs(value):g}")
        ax.grid(visible=False)
        bar = figure.colorbar(drawn, ax=ax, shrink=0.85, pad=0.02)
        bar.outline.set_visible(False)
        figure.suptitle(f"{title}, wall {wall}", x=0.01, ha="left", fontsize=10.5, fontweight="bold")
        return as_svg(figure, name, f"{title} on both final shapes")


def _extent(runs: list[RunResult]) -> tuple[float, float]:
    """Half width and height of the picture [mm], with room for the names above the shapes."""
    radius = max(run.final.outline["side"][:, 0].max() for run in runs) * MILLIMETRES
    height = max(run.final.outline["rear"][:, 1].max() for run in runs) * MILLIMETRES
    return max(1.1 * radius, 0.6 * height), 1.27 * height


def _outline(ax, run: RunResult, side: float) -> None:
    line = np.concatenate([run.final.outline[part] for part in ("foot", "side", "rear")])
    ax.plot(*(line * [side * MILLIMETRES, MILLIMETRES]).T, color=INK, linewidth=0.7)


def _name(ax, run: RunResult, side: float) -> None:
    ends = [f"R {run.quantities['foot_radius'].value * MILLIMETRES:.2f} mm"]
    ends.append(f"L {run.quantities['final_length'].value * MILLIMETRES:.2f} mm")
    ax.text(
        0.5 + 0.48 * side,
        0.98,
        "\n".join([f"{find_method(run.method).label} {run.resolution}", *ends]),
        transform=ax.transAxes,
        horizontalalignment="left" if side < 0.0 else "right",
        verticalalignment="top",
    )

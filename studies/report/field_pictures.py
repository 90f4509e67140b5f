"""Final shapes side by side, coloured by a field: one method left of the axis, the other right."""

from studies.comparisons.comparison import Comparison
from studies.methods.method import find_method
from studies.report.drawing import as_svg, drawing
from studies.report.half_shapes import LEFT, MILLIMETRES, RIGHT, draw_half, extent, finish, size
from studies.runs.result import RunResult

FIELDS = {
    "equivalent_plastic_strain": ("Equivalent plastic strain", "viridis"),
    "temperature": ("Temperature [K]", "inferno"),
    "damage": ("Damage", "cividis"),
    "porosity": ("Porosity", "magma"),
}


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
    title, colours = FIELDS[name]
    half_width, top = extent(runs)
    with drawing(*size(half_width, top)) as (figure, ax):
        limits = _range(name, runs)
        for run, side in ((runs[0], LEFT), (runs[-1], RIGHT)):
            drawn = draw_half(ax, run, run.final.fields[name], side, colours, limits)
            _name(ax, run, side)
        finish(figure, ax, drawn, half_width, top, f"{title}, wall {wall}")
        return as_svg(figure, name, f"{title} on both final shapes")


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

"""Maps of the difference of two methods' fields, drawn on the first method's final shape, and their norms."""

import numpy as np

from studies.comparisons.comparison import Comparison
from studies.comparisons.field_maps import FieldGap, FieldMaps
from studies.methods.method import find_method
from studies.output.display import SHOWN_UNITS, shown_title
from studies.report.drawing import as_svg, drawing
from studies.report.half_shapes import LEFT, RIGHT, draw_half, extent, finish, size
from studies.report.parts import Table

COLOURS = "RdBu_r"
CENTRAL = 99.0  # per cent of the points whose difference the colours resolve
TITLE = "Difference of the final fields"


def difference_maps(comparison: Comparison) -> list[str]:
    """One picture for each field; none without two methods."""
    maps = comparison.maps
    return [] if maps is None else [_picture(comparison, maps, gap) for gap in maps.gaps]


def difference_table(comparison: Comparison) -> Table:
    """The norms of the differences."""
    if comparison.maps is None or not comparison.maps.gaps:
        return Table(TITLE, (), ())
    gaps = comparison.maps.gaps
    head = ("field", "root mean square", "of the field's own [%]", "largest", "at R, Z [mm]")
    note = (
        f"{gaps[0].second} minus {gaps[0].first} at the end, as means over the cells of one even mesh of the "
        "undeformed bar, weighted with their volume; of temperature relative to its rise. On disk: difference.vtu over "
        "that mesh, difference-deformed.vtu on the first method's final shape."
    )
    return Table(TITLE, head, tuple(_row(gap) for gap in gaps), note)


def _row(gap: FieldGap) -> tuple:
    scale = SHOWN_UNITS[gap.unit][0]
    place = ", ".join(f"{1e3 * x:.3g}" for x in gap.position)
    relative = None if gap.relative is None else 100.0 * gap.relative
    return (_title(gap), gap.rms * scale, relative, gap.largest * scale, place)


def _title(gap: FieldGap) -> str:
    unit = SHOWN_UNITS[gap.unit][1]
    return shown_title(gap.field) + (f" [{unit}]" if unit else "")


def _picture(comparison: Comparison, maps: FieldMaps, gap: FieldGap) -> str:
    first = comparison.finest[0]
    difference = maps.second[gap.field] - maps.first[gap.field]
    values = difference[maps.cell_of] * SHOWN_UNITS[gap.unit][0]
    bound = float(np.nanpercentile(np.abs(values), CENTRAL)) or 1.0
    half_width, top = extent(comparison.finest)
    shorter = [f"{find_method(run.method).label} {run.resolution}" for run in comparison.finest]
    title = f"{_title(gap)}, {shorter[1]} − {shorter[0]}, wall {comparison.wall}"
    with drawing(*size(half_width, top)) as (figure, ax):
        for side in (LEFT, RIGHT):
            drawn = draw_half(ax, first, values, side, COLOURS, (-bound, bound))
        finish(figure, ax, drawn, half_width, top, title, extend="both")
        return as_svg(figure, f"difference-{gap.field}", title)

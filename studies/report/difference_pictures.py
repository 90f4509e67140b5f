"""Where the methods differ: one field's difference over the undeformed bar."""

import numpy as np

from studies.comparison import Comparison
from studies.report.drawing import as_svg, drawing
from studies.report.field_pictures import FIELDS, MILLIMETRES

WIDTH, HEIGHT = 4.6, 4.6  # inches


def difference_pictures(comparison: Comparison) -> list[str]:
    """One picture for each field that both methods have and differ in."""
    found = comparison.map
    if found is None:
        return []
    return [
        _picture(comparison, name) for name in FIELDS if name in found.fields and found.difference(name).any()
    ]


def _picture(comparison: Comparison, name: str) -> str:
    from matplotlib.collections import PolyCollection

    found, title = comparison.map, FIELDS[name][0]
    values = found.difference(name)
    most = float(np.abs(values).max())
    with drawing(WIDTH, HEIGHT) as (figure, ax):
        drawn = PolyCollection(
            found.cells * MILLIMETRES, array=values, cmap="RdBu_r", clim=(-most, most), linewidths=0.0,
            antialiased=False, rasterized=True,
        )  # fmt: skip
        ax.add_collection(drawn)
        radius, length = (MILLIMETRES * found.cells.reshape(-1, 2).max(axis=0)).tolist()
        ax.set(xlabel="r₀ [mm]", ylabel="z₀ [mm]", aspect="equal", xlim=(0.0, radius), ylim=(0.0, length))
        ax.grid(visible=False)
        bar = figure.colorbar(drawn, ax=ax, pad=0.04)
        bar.outline.set_visible(False)
        heading = f"{title}: {found.labels[1]} minus {found.labels[0]}, wall {comparison.wall}"
        figure.suptitle(heading, x=0.01, ha="left", fontsize=9.5, fontweight="bold")
        return as_svg(figure, f"difference-{name}", f"{heading}, over the undeformed bar")

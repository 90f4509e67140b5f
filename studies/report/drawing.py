"""Figures as inline SVG whose colours and fonts are the page's, so that they follow light, dark and print.

Figures are drawn with marker colours (INK, ...), which are replaced by the page's CSS variables afterwards.
"""

import io
import re
from collections.abc import Iterator
from contextlib import contextmanager
from html import escape

from core_models.errors import UnsupportedError
from studies.report.hover import attribute, curve_data

INK, FAINT, GRID = "#010101", "#020202", "#030303"
METHOD_COLOURS = {"fem-explicit": "#040404", "mpm": "#050505"}
VARIABLES = {
    INK: "--ink",
    FAINT: "--faint",
    GRID: "--grid",
    METHOD_COLOURS["fem-explicit"]: "--fem",
    METHOD_COLOURS["mpm"]: "--mpm",
}
STYLE = {
    "svg.fonttype": "none",
    "font.size": 10,
    "text.color": INK,
    "axes.labelcolor": INK,
    "axes.edgecolor": FAINT,
    "axes.linewidth": 0.7,
    "axes.grid": True,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.titlesize": 10.5,
    "axes.titleweight": "bold",
    "axes.titlelocation": "left",
    "grid.color": GRID,
    "grid.linewidth": 0.6,
    "xtick.color": FAINT,
    "ytick.color": FAINT,
    "xtick.labelcolor": INK,
    "ytick.labelcolor": INK,
    "legend.frameon": False,
    "legend.fontsize": 9,
    "lines.linewidth": 1.6,
    "savefig.transparent": True,
}


LINES = {"fem-explicit": "-", "mpm": (0, (4, 1.5))}
VARIANT_LINES = (":", (0, (1, 1, 4, 1)), (0, (6, 1)), (0, (2, 2)))

PANEL = (4.6, 3.1)  # inches; two stand side by side on a wide page, one above the other on a phone


def colour_of(method: str) -> str:
    """Colour of a method; its variants share it."""
    return METHOD_COLOURS[method.partition(":")[0]]


def line_of(method: str, methods: list[str]) -> str | tuple:
    """Line style of a method among those that are drawn: a variant's differs from its method's."""
    variants = [name for name in methods if ":" in name]
    if method in variants:
        return VARIANT_LINES[variants.index(method) % len(VARIANT_LINES)]
    return LINES[method]


@contextmanager
def drawing(width: float = PANEL[0], height: float = PANEL[1]) -> Iterator[tuple]:
    """A figure of width x height [inches] and its axes; UnsupportedError without matplotlib."""
    try:
        import matplotlib
        from matplotlib.figure import Figure
    except ImportError as error:
        raise UnsupportedError("report.html needs matplotlib: pip install 'matpoint[report]'") from error
    with matplotlib.rc_context(STYLE):
        figure = Figure(figsize=(width, height), layout="constrained")
        yield figure, figure.subplots()


def as_svg(figure, name: str, alternative: str) -> str:
    """The figure as an SVG element for a page; `name` keeps its inner ids apart from other figures'."""
    import matplotlib

    buffer = io.StringIO()
    with matplotlib.rc_context({"svg.hashsalt": name, "svg.fonttype": "none"}):
        figure.savefig(buffer, format="svg", dpi=200, metadata={"Date": None, "Creator": None})
    svg = buffer.getvalue()
    svg = svg[svg.index("<svg") :]
    svg = re.sub(r"<metadata>.*?</metadata>", "", svg, flags=re.S)
    for colour, variable in VARIABLES.items():
        svg = svg.replace(colour, f"var({variable})")
    svg = re.sub(r'id="(figure|axes|patch|text|line2d|matplotlib\.axis|xtick|ytick)_\d+"', "", svg)
    size = re.search(r'width="[\d.]+pt" height="[\d.]+pt" ', svg)
    svg = svg.replace(size.group(), "", 1) if size else svg
    data = curve_data(figure, VARIABLES)
    curves = f' data-curves="{attribute(data)}"' if data else ""
    return svg.replace("<svg ", f'<svg role="img" aria-label="{escape(alternative)}"{curves} ', 1)

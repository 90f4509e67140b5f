"""What the page's script needs to show the values of curves: where the axes stand in a figure, and the numbers."""

import json
from typing import Any

import numpy as np

POINTS_PER_INCH = 72.0
DIGITS = 5
EVEN = 20  # values of a curve from which on all curves are read at one abscissa
MOST = 600  # values of a curve that a page keeps


def curve_data(figure, variables: dict[str, str]) -> dict[str, Any] | None:
    """The labelled lines of a figure's first axes; None where there are none.

    box : left, top, right, bottom of the axes in the SVG's units; x, y : limits; log : whether the axes are
    logarithmic; together : whether the curves are read at one abscissa, or each at its own points; curves : name,
    colour, x, y. variables : the page's variable of each marker colour.
    """
    axes = figure.axes[0]
    lines = [line for line in axes.get_lines() if not str(line.get_label()).startswith("_")]
    curves = [curve for line in lines if (curve := _curve(line, variables))]
    if not curves:
        return None
    width, height = figure.get_size_inches() * POINTS_PER_INCH
    place = axes.get_position()
    box = (place.x0 * width, (1 - place.y1) * height, place.x1 * width, (1 - place.y0) * height)
    return {
        "box": [_short(v) for v in box],
        "x": [_short(v) for v in axes.get_xlim()],
        "y": [_short(v) for v in axes.get_ylim()],
        "log": [axes.get_xscale() == "log", axes.get_yscale() == "log"],
        "labels": [axes.get_xlabel(), axes.get_ylabel() or axes.get_title(loc="left")],
        "together": all(_is_function(curve["x"]) for curve in curves),
        "curves": curves,
    }


def attribute(data: dict[str, Any]) -> str:
    """The data as the value of an attribute."""
    text = json.dumps(data, ensure_ascii=False, separators=(",", ":"), allow_nan=False)
    return text.replace("&", "&amp;").replace('"', "&quot;").replace("<", "&lt;")


def _curve(line, variables: dict[str, str]) -> dict[str, Any] | None:
    x, y = (np.asarray(values, dtype=float) for values in (line.get_xdata(), line.get_ydata()))
    known = np.flatnonzero(np.isfinite(x) & np.isfinite(y))
    if not known.size:
        return None
    kept = known[:: -(-len(known) // MOST)]
    colour = line.get_color()
    return {
        "name": line.get_label(),
        "colour": f"var({variables[colour]})" if colour in variables else colour,
        "x": [_short(v) for v in x[kept]],
        "y": [_short(v) for v in y[kept]],
    }


def _is_function(x: list[float]) -> bool:
    return len(x) >= EVEN and bool(np.all(np.diff(x) >= 0.0))


def _short(value: float) -> float:
    return float(f"{value:.{DIGITS}g}")

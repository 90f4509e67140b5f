"""A quarter of the unit disk in three patches, without a degenerate corner at the centre (O-grid, butterfly).

A square core with slightly round outer sides, and two patches from these sides to the circle. The sides are arcs that
leave the axes at right angles and meet on the diagonal, where three patches come together at 120 degrees each.
"""

from math import pi, sqrt

import numpy as np

from meshes.patch import Patch, even_patch

_BULGE = 2.0 + sqrt(
    3.0
)  # distance of an arc's centre from the corner, along the axis: angle of 120 degrees there
_CORNER = 1.0 / (
    sqrt(_BULGE**2 + 1.0) - _BULGE + 1.0
)  # coordinate of the core's corner by the core's size on an axis


def quarter_disk(across: int, kind: str, along: int | None = None) -> list[Patch]:
    """Patches of the quarter disk x, y >= 0, x^2 + y^2 <= 1; with `along` in 3-D, of its cylinder 0 <= z <= 1.

    across : elements on the radius along an axis, at least 2. kind : of the elements. along : elements along z.
    Boundaries: outer, symmetry_x (x = 0), symmetry_y (y = 0), in 3-D also bottom and top.
    """
    core = core_count(across)
    size = core / across
    if along is None:
        lower, upper, ends, layers = "bottom", "top", {}, []
    else:
        lower, upper, ends, layers = "front", "back", {"bottom": "bottom", "top": "top"}, [along]
    inner = even_patch([core, core, *layers], kind)
    right = even_patch([across - core, core, *layers], kind)
    top = even_patch([core, across - core, *layers], kind)
    inner = inner.renamed(ends | {"left": "symmetry_x", lower: "symmetry_y"})
    right = right.renamed(ends | {"right": "outer", lower: "symmetry_y"})
    top = top.renamed(ends | {upper: "outer", "left": "symmetry_x"})
    return [
        inner.mapped(lambda x: _with_plane(x, _core(size, x[:, 0], x[:, 1]))),
        right.mapped(lambda x: _with_plane(x, _outside(size, x[:, 0], x[:, 1]))),
        top.mapped(lambda x: _with_plane(x, _outside(size, x[:, 1], x[:, 0])[:, ::-1])),
    ]


def core_count(across: int) -> int:
    """Elements along a side of the core: half of those on the radius, rounded up."""
    return (across + 1) // 2


def _with_plane(points: np.ndarray, plane: np.ndarray) -> np.ndarray:
    return np.column_stack([plane, points[:, 2:]])


def _side(size: float, t: np.ndarray) -> np.ndarray:
    """Points (n, 2) on the core's right side: t from 0 on the x-axis to 1 at the corner."""
    corner = _CORNER * size
    centre, radius = corner * (1.0 - _BULGE), corner * sqrt(_BULGE**2 + 1.0)
    angle = t * pi / 12.0
    return np.column_stack([centre + radius * np.cos(angle), radius * np.sin(angle)])


def _core(size: float, s: np.ndarray, t: np.ndarray) -> np.ndarray:
    """The core by interpolation between its sides: s and t from 0 to 1 along x and y."""
    right, top = _side(size, t), _side(size, s)[:, ::-1]
    return s[:, None] * right + t[:, None] * top - (s * t * _CORNER * size)[:, None]


def _outside(size: float, s: np.ndarray, t: np.ndarray) -> np.ndarray:
    """The patch beyond the core's right side: s from 0 there to 1 on the circle, t from the x-axis to the diagonal."""
    angle = t * pi / 4.0
    circle = np.column_stack([np.cos(angle), np.sin(angle)])
    return (1.0 - s)[:, None] * _side(size, t) + s[:, None] * circle

"""The Taylor bar: a solid cylinder, meshed in structured quads by gmsh."""

import math
from types import ModuleType

import numpy as np

from core_models.errors import MeshError
from meshes.gmsh_model import gmsh_model
from meshes.mesh import Mesh

STEEPEST_GRADING = 100.0
"""Ratio of axial sizes up to which gmsh places nodes to some 1e-5 of an element."""


def taylor_bar(
    radius: float,
    length: float,
    elements_across: int,
    elements_along: int | None = None,
    grading: float = 1.0,
    foot_height: float = 0.0,
) -> Mesh:
    """Mesh a solid cylinder that stands on its foot, in structured quads.

    Parameters: radius, length [m], > 0; elements_across: from axis to side, >= 1; elements_along: from foot
    to rear, >= 1 (default: as many as make square elements); grading: axial size of the elements at the foot
    divided by that at the rear, 0.01 to 100, in geometric progression between (1: all even); foot_height: z
    of the foot [m].
    Nodes and elements are numbered from the axis outwards, row by row from the foot.
    Raises MeshError when a parameter is outside its range or gmsh cannot be loaded.
    """
    if elements_along is None and radius > 0.0 and math.isfinite(length / radius):
        elements_along = max(1, round(elements_across * length / radius))
    _check(radius, length, elements_across, elements_along, grading, foot_height)
    with gmsh_model("taylor bar") as gmsh:
        _build_unit_square(gmsh, elements_across, elements_along, grading)
        unit_points, quads = _read_out(gmsh)
    order = _row_by_row(unit_points, elements_across, elements_along)
    unit_points = _put_rim_in_place(unit_points[order], elements_across, elements_along)
    points = unit_points * [radius, length] + [0.0, foot_height]
    nodes = np.arange(len(points)).reshape(elements_along + 1, elements_across + 1)
    rim = {"foot": nodes[0], "side": nodes[:, -1], "rear": nodes[-1, ::-1], "axis": nodes[::-1, 0]}
    boundaries = {name: np.column_stack([line[:-1], line[1:]]) for name, line in rim.items()}
    return Mesh(points, "quad4", _renumber(quads, order), boundaries, source="taylor bar")


def _check(
    radius: float, length: float, across: int, along: int | None, grading: float, foot_height: float
) -> None:
    """Raise MeshError for the first parameter that is outside its range."""
    for name, value in (("radius", radius), ("length", length)):
        if not (math.isfinite(value) and value > 0.0):
            raise MeshError(f"taylor bar: {name} is {value:g}; give a positive number")
    if not 1.0 / STEEPEST_GRADING <= grading <= STEEPEST_GRADING:
        raise MeshError(f"taylor bar: grading is {grading:g}; give a number from 0.01 to 100 (1 is even)")
    if not math.isfinite(foot_height):
        raise MeshError(f"taylor bar: foot_height is {foot_height:g}; give a finite number")
    for name, count in (("elements_across", across), ("elements_along", along)):
        if count is None or count != int(count) or count < 1:
            raise MeshError(f"taylor bar: {name} is {count}; give a whole number of at least 1")


def _build_unit_square(gmsh: ModuleType, across: int, along: int, grading: float) -> None:
    """Mesh the unit square; it is scaled afterwards because gmsh's tolerances are absolute lengths."""
    step_ratio = grading ** (-1.0 / (along - 1)) if along > 1 else 1.0
    geo = gmsh.model.geo
    corners = [geo.addPoint(x, y, 0.0) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
    foot, side, rear, axis = (geo.addLine(corners[i], corners[(i + 1) % 4]) for i in range(4))
    surface = geo.addPlaneSurface([geo.addCurveLoop([foot, side, rear, axis])])
    for line in (foot, rear):
        geo.mesh.setTransfiniteCurve(line, across + 1)
    geo.mesh.setTransfiniteCurve(side, along + 1, "Progression", step_ratio)
    geo.mesh.setTransfiniteCurve(axis, along + 1, "Progression", 1.0 / step_ratio)
    geo.mesh.setTransfiniteSurface(surface)
    geo.mesh.setRecombine(2, surface)
    geo.synchronize()
    gmsh.model.mesh.generate(2)


def _read_out(gmsh: ModuleType) -> tuple[np.ndarray, np.ndarray]:
    """Node coordinates (n, 2) and quads (m, 4) as indices into them."""
    tags, coordinates, _ = gmsh.model.mesh.getNodes()
    _, quad_nodes = gmsh.model.mesh.getElementsByType(gmsh.model.mesh.getElementType("Quadrangle", 1))
    index_of = np.zeros(int(tags.max()) + 1, dtype=np.int64)
    index_of[tags] = np.arange(len(tags))
    return coordinates.reshape(-1, 3)[:, :2], index_of[quad_nodes].reshape(-1, 4)


def _row_by_row(points: np.ndarray, across: int, along: int) -> np.ndarray:
    """Numbers of the nodes, from the axis outwards and row by row from the foot."""
    rows = points[:, 1].argsort().reshape(along + 1, across + 1)
    return np.take_along_axis(rows, points[rows, 0].argsort(axis=1), axis=1).ravel()


def _put_rim_in_place(points: np.ndarray, across: int, along: int) -> np.ndarray:
    """Take gmsh's round-off (some 1e-12) from the rim, so that radius, length and volume are exact."""
    grid = points.reshape(along + 1, across + 1, 2)
    grid[:, 0, 0], grid[:, -1, 0] = 0.0, 1.0
    grid[0, :, 1], grid[-1, :, 1] = 0.0, 1.0
    return grid.reshape(-1, 2)


def _renumber(quads: np.ndarray, order: np.ndarray) -> np.ndarray:
    """Quads in the new node numbers, each from its node of lowest number on, sorted by that node."""
    quads = order.argsort()[quads]
    first = quads.argmin(axis=1)[:, None]
    quads = np.take_along_axis(quads, (first + np.arange(4)) % 4, axis=1)
    return quads[quads[:, 0].argsort()]

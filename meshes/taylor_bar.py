"""The Taylor bar as a body of revolution: a solid cylinder in the (r, z) plane, meshed by gmsh."""

from types import ModuleType

import numpy as np

from core_models.errors import MeshError
from meshes.elevate import elevate
from meshes.gmsh_model import gmsh_model, read_out
from meshes.kinds import find_kind
from meshes.mesh import Mesh
from meshes.parameters import check_cylinder
from meshes.patch import Patch

SIDES = ("foot", "side", "rear", "axis")
"""The boundaries, counter-clockwise."""


def taylor_bar(
    radius: float,
    length: float,
    elements_across: int,
    elements_along: int | None = None,
    grading: float = 1.0,
    foot_height: float = 0.0,
    kind: str = "quad4",
    structured: bool = True,
) -> Mesh:
    """Mesh a solid cylinder that stands on its foot, in the (r, z) plane.

    Parameters: radius, length [m], > 0; elements_across: from axis to side (at the foot), >= 1; elements_along:
    from foot to rear, >= 1 (default: as many as make square elements; structured only); grading: axial size of the
    elements at the foot divided by that at the rear, 0.01 to 100, in geometric progression between (1: all even);
    foot_height: z of the foot [m]; kind: of the elements, 2-D; structured: rows and columns, of triangles two in
    place of a quad, numbered from the axis outwards, row by row from the foot; otherwise irregular triangles or
    recombined quads, of which an even number stands on the foot.
    Boundaries: foot, side, rear, axis, which follow each other counter-clockwise.
    Raises MeshError when a parameter is outside its range or gmsh cannot be loaded.
    """
    linear = find_kind(find_kind(kind, 2).linear)
    along = check_cylinder(
        "taylor bar", radius, length, elements_across, elements_along, grading, foot_height, 2
    )
    if structured:
        points, cells, boundaries = _rows(elements_across, along, grading, linear.name)
        points = points * [radius, length]
    else:
        _check_irregular(elements_across, elements_along, linear.name)
        points, cells, boundaries = _irregular(elements_across, length / radius, grading, linear.name)
        points = radius * points
        _put_in_place(points, boundaries, radius, length)
    mesh = Mesh(points + [0.0, foot_height], linear.name, cells, boundaries, source="taylor bar")
    return elevate(mesh, kind)


def _rows(across: int, along: int, grading: float, kind: str) -> Patch:
    """The unit square in rows and columns; it is scaled afterwards because gmsh's tolerances are lengths."""
    with gmsh_model("taylor bar") as gmsh:
        _build_unit_square(gmsh, across, along, grading)
        points, quads, _ = read_out(gmsh, "quad4", {})
    order = _row_by_row(points, across, along)
    points = _put_rim_in_place(points[order], across, along)
    nodes = np.arange(len(points)).reshape(along + 1, across + 1)
    rim = (nodes[0], nodes[:, -1], nodes[-1, ::-1], nodes[::-1, 0])
    boundaries = {name: np.column_stack([n[:-1], n[1:]]) for name, n in zip(SIDES, rim, strict=True)}
    cells = _renumber(quads, order)
    if kind == "tri3":
        cells = cells[:, [0, 1, 2, 0, 2, 3]].reshape(-1, 3)
    return Patch(points, cells, boundaries)


def _build_unit_square(gmsh: ModuleType, across: int, along: int, grading: float) -> None:
    """Mesh the unit square in rows of quads."""
    step_ratio = grading ** (-1.0 / (along - 1)) if along > 1 else 1.0
    surface, (foot, side, rear, axis) = _rectangle(gmsh, 1.0, 1.0, 1.0)
    mesh = gmsh.model.geo.mesh
    for line in (foot, rear):
        mesh.setTransfiniteCurve(line, across + 1)
    mesh.setTransfiniteCurve(side, along + 1, "Progression", step_ratio)
    mesh.setTransfiniteCurve(axis, along + 1, "Progression", 1.0 / step_ratio)
    mesh.setTransfiniteSurface(surface)
    mesh.setRecombine(2, surface)
    gmsh.model.geo.synchronize()
    gmsh.model.mesh.generate(2)


def _rectangle(
    gmsh: ModuleType, height: float, size_at_foot: float, size_at_rear: float
) -> tuple[int, list[int]]:
    """A rectangle of width 1: its surface, and its sides counter-clockwise from the foot."""
    geo = gmsh.model.geo
    corners = (
        (0, 0, size_at_foot),
        (1, 0, size_at_foot),
        (1, height, size_at_rear),
        (0, height, size_at_rear),
    )
    points = [geo.addPoint(x, y, 0.0, size) for x, y, size in corners]
    sides = [geo.addLine(points[i], points[(i + 1) % 4]) for i in range(4)]
    return geo.addPlaneSurface([geo.addCurveLoop(sides)]), sides


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


def _check_irregular(across: int, along: int | None, kind: str) -> None:
    """Raise MeshError for what irregular elements cannot follow."""
    if along is not None:
        raise MeshError("taylor bar: elements_along is for structured meshes; leave it out, and use grading")
    if kind == "quad4" and across % 2:
        raise MeshError(
            f"taylor bar: elements_across is {across}; give an even number for irregular quads, "
            f"such as {across + 1}"
        )


def _irregular(across: int, height: float, grading: float, kind: str) -> Patch:
    """A rectangle of width 1 in irregular triangles or quads."""
    with gmsh_model("taylor bar") as gmsh:
        surface, sides = _rectangle(gmsh, height, 1.0 / across, 1.0 / (across * grading))
        gmsh.model.geo.mesh.setTransfiniteCurve(sides[0], across + 1)
        if kind == "quad4":
            gmsh.model.geo.mesh.setRecombine(2, surface)
        gmsh.model.geo.synchronize()
        gmsh.model.mesh.generate(2)
        return read_out(gmsh, kind, {name: [tag] for name, tag in zip(SIDES, sides, strict=True)})


def _put_in_place(
    points: np.ndarray, boundaries: dict[str, np.ndarray], radius: float, length: float
) -> None:
    """Take gmsh's round-off from the rim."""
    for name, axis, value in (("foot", 1, 0.0), ("rear", 1, length), ("axis", 0, 0.0), ("side", 0, radius)):
        points[boundaries[name], axis] = value

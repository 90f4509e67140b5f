"""A quarter of the Taylor bar in 3-D, x, y >= 0, with two symmetry planes."""

import numpy as np

from core_models.errors import MeshError
from meshes.butterfly import quarter_disk
from meshes.elevate import elevate
from meshes.gmsh_model import gmsh_model, read_out
from meshes.kinds import find_kind
from meshes.mesh import Mesh
from meshes.parameters import check_count, check_cylinder
from meshes.patch import Patch, weld
from meshes.progression import progression

PLANES = {"foot": 2, "symmetry_x": 0, "symmetry_y": 1}
"""Boundaries on which a coordinate, given by its number, is zero."""


def taylor_quarter(
    radius: float,
    length: float,
    elements_across: int,
    elements_along: int | None = None,
    grading: float = 1.0,
    foot_height: float = 0.0,
    kind: str = "hex8",
    structured: bool = True,
) -> Mesh:
    """Mesh the quarter x, y >= 0 of a solid cylinder about z that stands on its foot.

    Parameters: radius, length [m], > 0; elements_across: on the radius along an axis, >= 2; elements_along: layers
    from foot to rear (default: as many as make them as high as elements on the axes are wide; structured only);
    grading: height of the elements at the foot divided by that at the rear, 0.01 to 100, in geometric progression
    between; foot_height: z of the foot [m]; kind: of the elements, 3-D; structured: layers of a square core and two
    patches from it to the circle, so that no element has an edge on the axis only; of tetrahedra six in place of a
    hexahedron; otherwise irregular tetrahedra. Middle nodes of quadratic kinds lie on the cylinder.
    Boundaries: foot, side, rear, symmetry_x (x = 0), symmetry_y (y = 0).
    Raises MeshError when a parameter is outside its range, for irregular hexahedra, or when gmsh cannot be loaded.
    """
    body, wanted = "taylor quarter", find_kind(kind, 3)
    along = check_cylinder(body, radius, length, elements_across, elements_along, grading, foot_height, 3)
    check_count(body, "elements_across", elements_across, 2)
    if structured:
        points, cells, boundaries = _layers(elements_across, along, grading, length / radius, kind)
    elif not wanted.simplex:
        raise MeshError(
            f"{body}: irregular {kind} elements are not offered; give structured=True, or tet4 or tet10"
        )
    elif elements_along is not None:
        raise MeshError(f"{body}: elements_along is for structured meshes; leave it out, and use grading")
    else:
        points, cells, boundaries = _irregular(elements_across, grading, length / radius, kind)
    points = radius * points
    for name, axis in PLANES.items():
        points[boundaries[name], axis] = 0.0
    points[boundaries["rear"], 2] = length
    return Mesh(points + [0.0, 0.0, foot_height], kind, cells, boundaries, source=body)


def _layers(across: int, along: int, grading: float, height: float, kind: str) -> Patch:
    """A cylinder of radius 1 in layers."""
    patch = weld(quarter_disk(across, kind, along))
    names = {name: name for name in ("symmetry_x", "symmetry_y")}
    patch = patch.renamed({"bottom": "foot", "outer": "side", "top": "rear"} | names)
    patch.points[:, 2] = height * progression(patch.points[:, 2], along, grading)
    return patch


def _irregular(across: int, grading: float, height: float, kind: str) -> Patch:
    """A cylinder of radius 1 in irregular tetrahedra."""
    with gmsh_model("taylor quarter") as gmsh:
        geo = gmsh.model.geo
        rings = []
        for z, size in ((0.0, 1.0 / across), (height, 1.0 / (across * grading))):
            centre, on_x, on_y = (geo.addPoint(x, y, z, size) for x, y in ((0, 0), (1, 0), (0, 1)))
            lines = [
                geo.addLine(centre, on_x),
                geo.addCircleArc(on_x, centre, on_y),
                geo.addLine(on_y, centre),
            ]
            rings.append(((centre, on_x, on_y), lines))
        (low_points, low), (high_points, high) = rings
        upright = [geo.addLine(a, b) for a, b in zip(low_points, high_points, strict=True)]
        foot = geo.addPlaneSurface([geo.addCurveLoop([-line for line in reversed(low)])])
        rear = geo.addPlaneSurface([geo.addCurveLoop(high)])
        loops = [geo.addCurveLoop([low[i], upright[(i + 1) % 3], -high[i], -upright[i]]) for i in range(3)]
        on_y0, side, on_x0 = (
            geo.addPlaneSurface([loops[0]]),
            geo.addSurfaceFilling([loops[1]]),
            geo.addPlaneSurface([loops[2]]),
        )
        geo.addVolume([geo.addSurfaceLoop([foot, rear, on_y0, side, on_x0])])
        geo.synchronize()
        gmsh.model.mesh.generate(3)
        named = {"foot": [foot], "side": [side], "rear": [rear], "symmetry_x": [on_x0], "symmetry_y": [on_y0]}
        points, cells, boundaries = read_out(gmsh, "tet4", named)
    nodes = np.unique(boundaries["side"])
    points[nodes] = _onto_cylinder(points[nodes])
    mesh = elevate(Mesh(points, "tet4", cells, boundaries, "taylor quarter"), kind, {"side": _onto_cylinder})
    return Patch(mesh.points, mesh.cells, mesh.boundaries)


def _onto_cylinder(points: np.ndarray) -> np.ndarray:
    """The nearest points on the cylinder of radius 1."""
    radius = np.hypot(points[:, 0], points[:, 1])
    return np.column_stack([points[:, :2] / radius[:, None], points[:, 2]])

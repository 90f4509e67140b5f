"""Ends of the grid at which the body is held, and the lines between the cells.

The grid ends at every boundary that is held and is a whole plane face of the body, normal to an axis. The functions
that are not 0 there have the sum 1, so that they alone carry a motion that is prescribed, exactly. What is held
elsewhere is held by springs (mpm.implicit.weak_supports).
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from core_models.arguments import check_between
from core_models.errors import SceneError
from core_models.geometry import Axisymmetric, Geometry, axis_names
from core_models.loads import Load, Prescribed, Symmetry, supports
from core_models.symmetry import FLAT, symmetry_plane
from meshes.mesh import Mesh

LOW, HIGH = 0, 1
FIT = 1e-6  # cells that a line may be off a plane, or the body may stick out of the grid
MOST_CELLS = 1_000_000  # along an axis


class Plane(NamedTuple):
    """An end of the grid: normal to an axis, LOW or HIGH along it, at a position [m]."""

    axis: int
    end: int
    position: float


def held_planes(mesh: Mesh, geometry: Geometry, loads: tuple[Load, ...]) -> dict[str, Plane]:
    """The planes, by name, of the boundaries that are held and are whole plane faces of the body."""
    held = [load.boundary for load in loads if isinstance(load, Symmetry)]
    held += [load.boundary for load in supports(loads, mesh.dimension)]
    planes = {}
    for name in dict.fromkeys(held):
        try:
            axis, position, side = symmetry_plane(mesh, name, axis_names(geometry))
        except SceneError:
            continue
        if _is_whole(mesh, name, axis, position):
            planes[name] = Plane(axis, LOW if side > 0 else HIGH, position)
    return planes


def _is_whole(mesh: Mesh, name: str, axis: int, position: float) -> bool:
    size = float(np.ptp(mesh.points, axis=0).max())
    there = np.flatnonzero(np.abs(mesh.points[:, axis] - position) <= FLAT * size)
    return not np.setdiff1d(there, mesh.boundaries[name]).size


def weakly_held(mesh: Mesh, loads: tuple[Load, ...], planes: dict[str, Plane]) -> list[Prescribed]:
    """Components that are prescribed on boundaries without such a plane."""
    held = [
        Prescribed(load.boundary, symmetry_plane(mesh, load.boundary)[0])
        for load in loads
        if isinstance(load, Symmetry)
    ]
    held += supports(loads, mesh.dimension)
    return [support for support in held if support.boundary not in planes]


def held_ends(mesh: Mesh, geometry: Geometry, planes: dict[str, Plane]) -> set[tuple[int, int]]:
    """Axis, and LOW or HIGH along it, of the ends of the grid at which the body is held; the axis r = 0 is one."""
    ends = {(plane.axis, plane.end) for plane in planes.values()}
    on_axis = isinstance(geometry, Axisymmetric) and mesh.points[:, 0].min() == 0.0
    return ends | {(0, LOW)} if on_axis else ends


def grid_lines(
    mesh: Mesh, geometry: Geometry, ends: set[tuple[int, int]], cell_size: float | Sequence[ArrayLike]
) -> list[np.ndarray]:
    """The lines between the cells along each axis (cells + 1,) [m].

    ends : (axis, LOW or HIGH) at which the body is held. cell_size : of all cells, or for each axis a size or the lines
    themselves [m]. Cells of a given size begin at the plane that holds the body, else at the body's lower end; between
    two planes they are made to fit.
    Raises SceneError for lines that do not ascend, leave a part of the body out or do not end on a plane.
    """
    names, d = axis_names(geometry), mesh.dimension
    sizes = list(cell_size) if isinstance(cell_size, Sequence) else [cell_size] * d
    if len(sizes) != d:
        raise SceneError(
            f"cell_size has {len(sizes)} entries: give one size, or a size or lines for each of {', '.join(names[:d])}"
        )
    low, high = mesh.points.min(axis=0), mesh.points.max(axis=0)
    lines = []
    for axis, size in enumerate(sizes):
        held = [(axis, end) in ends for end in (LOW, HIGH)]
        if np.ndim(size) == 0:
            size = check_between("cell_size", size, 0.0, np.inf, "m")
            lines.append(_even(size, low[axis], high[axis], held, names[axis]))
        else:
            lines.append(_given(np.asarray(size, dtype=np.float64), low[axis], high[axis], held, names[axis]))
    return lines


def _even(size: float, low: float, high: float, held: list[bool], name: str) -> np.ndarray:
    whole = (high - low) / size
    if whole > MOST_CELLS:
        raise SceneError(
            f"cell_size = {size:g} m makes {whole:.3g} cells along {name}: give at least "
            f"{(high - low) / MOST_CELLS:.3g} m"
        )
    if all(held):
        return np.linspace(low, high, max(round(whole), 1) + 1)
    count = max(int(np.ceil(whole - FIT)), 1)
    steps = size * np.arange(count + 1)
    return high - steps[::-1] if held[HIGH] else low + steps


def _given(lines: np.ndarray, low: float, high: float, held: list[bool], name: str) -> np.ndarray:
    if lines.ndim != 1 or len(lines) < 2 or not np.isfinite(lines).all() or not (np.diff(lines) > 0.0).all():
        raise SceneError(f"cell_size along {name}: give two or more finite lines in ascending order")
    slack = FIT * float(np.diff(lines).min())
    for end, at, beyond in ((LOW, low, lines[0] - low), (HIGH, high, high - lines[-1])):
        edge = lines[0] if end == LOW else lines[-1]
        if beyond > slack:
            raise SceneError(
                f"the grid ends at {name} = {edge:.6g} m, the body at {at:.6g} m: give lines that cover it"
            )
        if held[end] and beyond < -slack:
            raise SceneError(
                f"the body is held at {name} = {at:.6g} m, but the grid ends at {edge:.6g} m: let it end there too"
            )
    return lines

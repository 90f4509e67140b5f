"""Where particles may be, and whether a grid is fine enough for a body."""

from collections.abc import Sequence

import numpy as np

from core_models.errors import SceneError
from core_models.geometry import Geometry, axis_names
from core_models.walls import Wall
from meshes.mesh import Mesh
from mpm.mirrors import Mirror

FEWEST_CELLS = 2.0  # across a body, its mirror image included


def bounds_of(
    mesh: Mesh, cell_size: float, base: np.ndarray, mirrors: Sequence[Mirror], wall: Wall | None
) -> np.ndarray:
    """Lowest and highest coordinates (d, 2) of particles [m]: up to symmetry planes, and a cell beyond the wall."""
    bounds = np.tile([-np.inf, np.inf], (mesh.dimension, 1))
    for mirror in mirrors:
        bounds[mirror.axis, 0 if mirror.side > 0 else 1] = base[mirror.axis] + mirror.cell * cell_size
    if wall is not None:
        bounds[-1, 0] = max(bounds[-1, 0], -cell_size)
    return bounds


def check_size(mesh: Mesh, geometry: Geometry, cell_size: float, mirrors: Sequence[Mirror]) -> None:
    """Refuse a grid too coarse for the body; SceneError with the numbers."""
    sizes = np.ptp(mesh.points, axis=0)
    mirrored = {mirror.axis for mirror in mirrors}
    for axis, size in enumerate(sizes):
        whole = 2.0 * size if axis in mirrored else size
        if whole < FEWEST_CELLS * cell_size * (1.0 - 1e-9):
            raise SceneError(
                f"the grid is too coarse: the body is {size:.4g} m across along {axis_names(geometry)[axis]}, which is "
                f"{size / cell_size:.3g} cells of {cell_size:.4g} m: give cells of at most "
                f"{whole / FEWEST_CELLS:.4g} m"
            )

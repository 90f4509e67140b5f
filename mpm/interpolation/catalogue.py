"""The interpolations by name."""

import numpy as np

from core_models.errors import SceneError
from core_models.names import suggestion
from meshes.mesh import Mesh
from mpm.interpolation.cubic import CubicSpline
from mpm.interpolation.gimp import UniformGimp
from mpm.interpolation.linear import LinearHat
from mpm.interpolation.quadratic import QuadraticSpline
from mpm.particles import domain_corners

INTERPOLATIONS = {
    "linear": LinearHat,
    "gimp": UniformGimp,
    "quadratic": QuadraticSpline,
    "cubic": CubicSpline,
}

Interpolation = LinearHat | UniformGimp | QuadraticSpline | CubicSpline


def check_interpolation(name: str) -> None:
    """Refuse an interpolation that does not exist; SceneError with the nearest name."""
    if name not in INTERPOLATIONS:
        raise SceneError(f"no interpolation is called {name!r}; {suggestion(name, INTERPOLATIONS)}")


def make_interpolation(
    name: str, cell_size: float, mesh: Mesh, seeding: str, areas: np.ndarray
) -> Interpolation:
    """The interpolation of a name for the particles of a mesh, whose domains have these areas or volumes (n,) [m^d].

    Raises SceneError where GIMP's particles are wider than a cell, for then they would reach beyond three nodes.
    """
    if name != "gimp":
        return INTERPOLATIONS[name]()
    box = np.ptp(domain_corners(mesh, seeding), axis=1)
    shrink = (areas / box.prod(axis=1)) ** (1.0 / box.shape[1])
    halves = 0.5 * box * shrink[:, None]
    widest = 2.0 * float(halves.max())
    if widest > cell_size * (1.0 + 1e-9):
        raise SceneError(
            f"interpolation 'gimp' needs particles no wider than a cell: the widest has {widest:.4g} m, the cells have "
            f"{cell_size:.4g} m: give larger cells or a finer mesh"
        )
    return UniformGimp(np.minimum(halves, 0.5 * cell_size))

"""The interpolations by name."""

import numpy as np

from core_models.errors import SceneError
from core_models.names import suggestion
from meshes.mesh import Mesh
from mpm import convected as convected  # registers what convected domains exchange with the grid
from mpm.interpolation.cpdi import ConvectedDomain, check_seeding, half_edges
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
    "cpdi": ConvectedDomain,
}

Interpolation = LinearHat | UniformGimp | QuadraticSpline | CubicSpline | ConvectedDomain


def check_interpolation(name: str) -> None:
    """Refuse an interpolation that does not exist; SceneError with the nearest name."""
    if name not in INTERPOLATIONS:
        raise SceneError(f"no interpolation is called {name!r}; {suggestion(name, INTERPOLATIONS)}")


def make_interpolation(
    name: str, cell_size: float, mesh: Mesh, seeding: str, areas: np.ndarray, deformation_gradient: np.ndarray
) -> Interpolation:
    """The interpolation of a name for the particles of a mesh, whose domains have these areas or volumes (n,) [m^d].

    deformation_gradient : (n, 3, 3) at the start.
    Raises SceneError where domains are so wide that they would reach more nodes than there is room for.
    """
    if name == "gimp":
        return _gimp(cell_size, domain_corners(mesh, seeding), areas)
    if name == "cpdi":
        shape = ConvectedDomain(half_edges(domain_corners(mesh, seeding), areas), deformation_gradient)
        check_seeding(shape, cell_size)
        return shape
    return INTERPOLATIONS[name]()


def _gimp(cell_size: float, domains: np.ndarray, areas: np.ndarray) -> UniformGimp:
    box = np.ptp(domains, axis=1)
    shrink = (areas / box.prod(axis=1)) ** (1.0 / box.shape[1])
    halves = 0.5 * box * shrink[:, None]
    widest = 2.0 * float(halves.max())
    if widest > cell_size * (1.0 + 1e-9):
        raise SceneError(
            f"interpolation 'gimp' needs particles no wider than a cell: the widest has {widest:.4g} m, the cells have "
            f"{cell_size:.4g} m: give larger cells or a finer mesh"
        )
    return UniformGimp(np.minimum(halves, 0.5 * cell_size))

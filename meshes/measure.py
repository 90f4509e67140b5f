"""Areas and volumes of elements of all kinds, by quadrature that is exact for their shape functions."""

from functools import cache

import numpy as np

from meshes.jacobians import CHUNK, determinants, jacobian_matrices
from meshes.kinds import KINDS
from meshes.mesh import Mesh
from meshes.shape_functions import shape_values


def measures(mesh: Mesh) -> np.ndarray:
    """Areas [m^2] in 2-D, volumes [m^3] in 3-D, of the elements (m,): integral of det J over the reference cell."""
    return _integrals(mesh, np.ones(len(mesh.points)))


def volumes_of_turn(mesh: Mesh) -> np.ndarray:
    """Volumes [m^3] that the elements (m,) of a mesh in the (r, z) plane sweep in a full turn: 2 pi integral of r."""
    return 2.0 * np.pi * _integrals(mesh, mesh.points[:, 0])


def _integrals(mesh: Mesh, values: np.ndarray) -> np.ndarray:
    """Integrals (m,) over each element of the field with nodal values (n,)."""
    places, weights = quadrature(mesh.kind)
    shape = shape_values(mesh.kind, places)
    parts = []
    for first in range(0, len(mesh.cells), CHUNK):
        cells = mesh.cells[first : first + CHUNK]
        jacobians = determinants(jacobian_matrices(mesh.kind, mesh.points[cells], places))
        parts.append(((values[cells] @ shape.T) * jacobians) @ weights)
    return np.concatenate(parts)


@cache
def quadrature(kind: str) -> tuple[np.ndarray, np.ndarray]:
    """Places (q, d) and weights (q,) of 3-point Gauss rules along each direction; simplices as collapsed cubes.

    Exact for the volume of any element, and in 2-D for its first moments.
    """
    dimension = KINDS[kind].dimension
    x, w = np.polynomial.legendre.leggauss(3)
    x, w = 0.5 * (x + 1.0), 0.5 * w
    places = np.stack(np.meshgrid(*[x] * dimension, indexing="ij"), axis=-1).reshape(-1, dimension)
    weights = np.prod(np.stack(np.meshgrid(*[w] * dimension, indexing="ij"), axis=-1), axis=-1).ravel()
    if KINDS[kind].simplex:
        left = np.ones(len(places))
        for k in range(dimension):
            weights = weights * left
            places[:, k] *= left
            left = left - places[:, k]
    return places, weights

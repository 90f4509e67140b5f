"""Particles: where they start, the domain that each stands for, and the body's boundary as faces of domains."""

from typing import NamedTuple

import numpy as np

GAUSS = "gauss"
LATTICE = "lattice"

# Quarters of a quad, in the order of scikit-fem's 2 x 2 points: corners in local coordinates, counter-clockwise.
_LOCAL = np.array(
    [[(s, t), (s + 0.5, t), (s + 0.5, t + 0.5), (s, t + 0.5)] for s in (0.0, 0.5) for t in (0.0, 0.5)]
)
_GAUSS = 0.5 - 0.5 / np.sqrt(3.0)
_GAUSS_POINTS = np.array([(s, t) for s in (_GAUSS, 1.0 - _GAUSS) for t in (_GAUSS, 1.0 - _GAUSS)])
# Quarters and their corners along each edge of a quad, in the edge's direction: edge k joins local nodes k and k + 1.
_EDGE_QUARTERS = ((0, 2), (2, 3), (3, 1), (1, 0))


class Particles(NamedTuple):
    """Particles in the reference body.

    positions : (n, 2) [m]. volumes : (n,) 2 pi r A [m^3]. corners : (n, 4, 2) corners of the domain relative to the
    particle [m]. faces : name of a boundary -> (k, 2) particle and first corner (0 ... 3) of each face along it.
    """

    positions: np.ndarray
    volumes: np.ndarray
    corners: np.ndarray
    faces: dict[str, np.ndarray]


def seed(mesh, seeding: str = GAUSS) -> Particles:
    """Four particles in each quad of a `meshes.QuadMesh`.

    seeding : 'gauss' puts them at the points of the finite element method, with its weights; 'lattice' at the middle
    of the quarters, with the quarters' volumes.
    """
    nodes = mesh.points[mesh.quads]
    domains = np.einsum("qcI,eIk->eqck", _shape(_LOCAL), nodes).reshape(-1, 4, 2)
    if seeding == GAUSS:
        positions = np.einsum("qI,eIk->eqk", _shape(_GAUSS_POINTS), nodes).reshape(-1, 2)
        volumes = 2.0 * np.pi * positions[:, 0] * _areas_at_gauss_points(nodes)
    else:
        volumes = 2.0 * np.pi * _first_moments(domains)
        positions = domains.mean(axis=1)
    return Particles(positions, volumes, domains - positions[:, None, :], _faces(mesh))


def _shape(local: np.ndarray) -> np.ndarray:
    """Bilinear shape functions at local coordinates (..., 2) in [0, 1]^2: (..., 4)."""
    s, t = local[..., 0], local[..., 1]
    return np.stack([(1 - s) * (1 - t), s * (1 - t), s * t, (1 - s) * t], axis=-1)


def _areas_at_gauss_points(nodes: np.ndarray) -> np.ndarray:
    """Weight of each 2 x 2 Gauss point in the (r, z) plane: determinant of the map / 4 [m^2]."""
    s, t = _GAUSS_POINTS[:, 0], _GAUSS_POINTS[:, 1]
    by_s = np.stack([t - 1, 1 - t, t, -t], axis=-1)
    by_t = np.stack([s - 1, -s, s, 1 - s], axis=-1)
    a, b = np.einsum("qI,eIk->eqk", by_s, nodes), np.einsum("qI,eIk->eqk", by_t, nodes)
    return (0.25 * (a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0])).ravel()


def _first_moments(polygons: np.ndarray) -> np.ndarray:
    """Integral of r over polygons (n, 4, 2) [m^3]."""
    r, z = polygons[..., 0], polygons[..., 1]
    r1, z1 = np.roll(r, -1, axis=1), np.roll(z, -1, axis=1)
    return ((r + r1) * (r * z1 - r1 * z)).sum(axis=1) / 6.0


def _faces(mesh) -> dict[str, np.ndarray]:
    edges = {}
    for element, quad in enumerate(mesh.quads.tolist()):
        for edge in range(4):
            edges[quad[edge], quad[(edge + 1) % 4]] = (element, edge)
    faces = {}
    for name, pairs in mesh.boundaries.items():
        if name == "axis":
            continue
        found = []
        for a, b in pairs.tolist():
            element, edge = edges[a, b]
            found += [(4 * element + quarter, edge) for quarter in _EDGE_QUARTERS[edge]]
        faces[name] = np.array(found, dtype=np.int64)
    return faces

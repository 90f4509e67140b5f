"""Particles: where they start, the domain that each stands for, and the body's boundary as faces of domains."""

from typing import NamedTuple

import numpy as np

from meshes.mesh import Mesh
from meshes.quarters import EDGE_QUARTERS, gauss_points, quarter_polygons

GAUSS = "gauss"
LATTICE = "lattice"


class Particles(NamedTuple):
    """Particles in the reference body.

    positions : (n, 2) [m]. volumes : (n,) 2 pi r A [m^3]. corners : (n, 4, 2) corners of the domain relative to the
    particle [m]. faces : name of a boundary -> (k, 2) particle and first corner (0 ... 3) of each face along it.
    """

    positions: np.ndarray
    volumes: np.ndarray
    corners: np.ndarray
    faces: dict[str, np.ndarray]


def seed(mesh: Mesh, seeding: str = GAUSS) -> Particles:
    """Four particles in each quad of a mesh.

    seeding : 'gauss' puts them at the points of the finite element method, with its weights; 'lattice' at the middle
    of the quarters, with the quarters' volumes.
    """
    domains = quarter_polygons(mesh.corners())
    if seeding == GAUSS:
        positions, areas = gauss_points(mesh.corners())
        volumes = 2.0 * np.pi * positions[:, 0] * areas
    else:
        volumes = 2.0 * np.pi * _first_moments(domains)
        positions = domains.mean(axis=1)
    return Particles(positions, volumes, domains - positions[:, None, :], _faces(mesh))


def _first_moments(polygons: np.ndarray) -> np.ndarray:
    """Integral of r over polygons (n, 4, 2) [m^3]."""
    r, z = polygons[..., 0], polygons[..., 1]
    r1, z1 = np.roll(r, -1, axis=1), np.roll(z, -1, axis=1)
    return ((r + r1) * (r * z1 - r1 * z)).sum(axis=1) / 6.0


def _faces(mesh: Mesh) -> dict[str, np.ndarray]:
    """Faces of the particles' domains along each boundary: particle and first corner."""
    edges = {}
    for element, quad in enumerate(mesh.cells.tolist()):
        for edge in range(4):
            edges[quad[edge], quad[(edge + 1) % 4]] = (element, edge)
    faces = {}
    for name, pairs in mesh.boundaries.items():
        if name == "axis":
            continue
        found = []
        for a, b in pairs.tolist():
            element, edge = edges[a, b]
            found += [(4 * element + quarter, edge) for quarter in EDGE_QUARTERS[edge]]
        faces[name] = np.array(found, dtype=np.int64)
    return faces

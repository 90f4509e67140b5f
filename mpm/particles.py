"""Particles: where they start, the domain that each stands for, and the body's boundary as faces of domains."""

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np

from core_models.errors import SceneError
from core_models.geometry import Axisymmetric, Geometry
from core_models.names import suggestion
from meshes.facets import find_facets
from meshes.kinds import KINDS
from meshes.mesh import Mesh
from meshes.shape_functions import shape_gradients, shape_values
from meshes.subdivision import Subdivision, lattice, subdivision

GAUSS = "gauss"
LATTICE = "lattice"
ALONG = 2  # particles of a lattice along each edge of an element
TWO_POINTS = 0.5 + np.array([-0.5, 0.5]) / np.sqrt(3.0)


class Faces(NamedTuple):
    """Faces of particles' domains along one boundary.

    particles (k,). corners (k, 2, d) or (k, 4, d) : relative to the particle in the reference body [m], seen from
    outside, in 2-D head to tail.
    """

    particles: np.ndarray
    corners: np.ndarray


class Particles(NamedTuple):
    """Particles in the reference body, in the order of the elements and of the points in them.

    positions (n, d) [m]. volumes (n,) [m^3]. areas (n,) : of the domains in the plane [m^2]; volumes again in 3-D.
    faces : name of a boundary -> Faces; none for a boundary on the axis of a body of revolution.
    """

    positions: np.ndarray
    volumes: np.ndarray
    areas: np.ndarray
    faces: dict[str, Faces]


def parts_of(mesh: Mesh, seeding: str) -> Subdivision:
    """How the elements are cut into domains of particles.

    seeding : 'gauss' puts particles at the points of the finite element method's full rule, with its weights;
    'lattice' at the middle of even parts of quads and hexahedra, with the parts' volumes.
    Raises SceneError for an unknown seeding or a lattice in triangles or tetrahedra.
    """
    if seeding not in (GAUSS, LATTICE):
        raise SceneError(f"no seeding is called {seeding!r}; {suggestion(seeding, (GAUSS, LATTICE))}")
    if seeding == GAUSS:
        return subdivision(mesh.kind)
    if KINDS[mesh.kind].simplex:
        raise SceneError(f"seeding 'lattice' needs quads or hexahedra, not {mesh.kind}: use 'gauss'")
    return lattice(mesh.kind, ALONG)


def seed(mesh: Mesh, geometry: Geometry, seeding: str = GAUSS) -> Particles:
    """Particles in each element of a mesh; see `parts_of`."""
    parts = parts_of(mesh, seeding)
    if seeding == GAUSS:
        positions = _mapped(mesh, parts.places)
        measures = (parts.weights * _ratios(mesh, parts.places)).ravel()
        volumes = _revolved(measures, positions.reshape(-1, mesh.dimension), geometry)
        areas = measures
    else:
        positions = _mapped(mesh, parts.corners.reshape(-1, mesh.dimension))
        positions = positions.reshape(*positions.shape[:1], -1, parts.corners.shape[1], mesh.dimension).mean(
            axis=2
        )
        areas, volumes = _measures(mesh, parts, geometry)
    positions = np.ascontiguousarray(positions.reshape(-1, mesh.dimension))
    return Particles(positions, volumes, areas, _faces(mesh, geometry, parts, positions))


def domain_corners(mesh: Mesh, seeding: str = GAUSS) -> np.ndarray:
    """Corners (n, 2^d, d) [m] of the domains of all particles in the reference body; those of simplices repeat."""
    corners = parts_of(mesh, seeding).corners
    shape = (len(mesh.cells) * len(corners), *corners.shape[1:])
    return _mapped(mesh, corners.reshape(-1, mesh.dimension)).reshape(shape)


def _mapped(mesh: Mesh, places: np.ndarray, cells: slice | np.ndarray = slice(None)) -> np.ndarray:
    """Positions (m, q, d) of reference coordinates (q, d) in the cells."""
    return np.einsum("qa,mai->mqi", shape_values(mesh.kind, places), mesh.points[mesh.cells[cells]])


def _ratios(mesh: Mesh, places: np.ndarray) -> np.ndarray:
    """Determinant (m, q) of the map at reference coordinates (q, d)."""
    gradients = shape_gradients(mesh.kind, places)
    return np.linalg.det(np.einsum("qak,mai->mqik", gradients, mesh.points[mesh.cells]))


def _revolved(areas: np.ndarray, positions: np.ndarray, geometry: Geometry) -> np.ndarray:
    """Volumes of what has these areas (or volumes) at these positions."""
    return 2.0 * np.pi * positions[:, 0] * areas if isinstance(geometry, Axisymmetric) else areas


def _measures(mesh: Mesh, parts: Subdivision, geometry: Geometry) -> tuple[np.ndarray, np.ndarray]:
    """Areas and volumes (n,) of the parts themselves, by two points along each edge of a part."""
    d = mesh.dimension
    rule = np.stack(np.meshgrid(*[TWO_POINTS] * d), axis=-1).reshape(-1, d)
    low, size = parts.corners[:, 0], parts.corners.max(axis=1) - parts.corners[:, 0]
    places = (low[:, None] + rule * size[:, None]).reshape(-1, d)
    weights = np.repeat(size.prod(axis=1) / len(rule), len(rule))
    areas = weights * _ratios(mesh, places)
    positions = _mapped(mesh, places)
    volumes = _revolved(areas.ravel(), positions.reshape(-1, d), geometry)
    return tuple(values.reshape(-1, len(rule)).sum(axis=1) for values in (areas, volumes))


def rim_faces(
    mesh: Mesh, geometry: Geometry, seeding: str, particles: Particles, mirrored: Iterable[str]
) -> Faces:
    """Faces of the particles' domains along the whole rim, named or not; named ones come first.

    What lies on the axis or belongs to a `mirrored` boundary is inside the whole body, and not on its rim.
    """
    facets = find_facets(mesh.kind, mesh.points, mesh.cells)
    per_cell = len(KINDS[mesh.kind].facets)
    number_of = {name: mesh.owners(name) @ [per_cell, 1] for name in mesh.boundaries}
    numbers = np.concatenate([*(number_of[name] for name in particles.faces), facets.rim()])
    numbers = numbers[np.sort(np.unique(numbers, return_index=True)[1])]
    for name in mirrored:
        numbers = numbers[~np.isin(numbers, number_of[name])]
    if isinstance(geometry, Axisymmetric):
        numbers = numbers[(mesh.points[facets.nodes[numbers], 0] != 0.0).any(axis=1)]
    owners = np.column_stack(np.divmod(numbers, per_cell))
    return _faces_on(mesh, owners, parts_of(mesh, seeding), particles.positions)


def _faces(mesh: Mesh, geometry: Geometry, parts: Subdivision, positions: np.ndarray) -> dict[str, Faces]:
    """Faces along each boundary, but for those on the axis of a body of revolution."""
    on_axis = (
        mesh.points[:, 0] == 0.0 if isinstance(geometry, Axisymmetric) else np.zeros(len(mesh.points), bool)
    )
    return {
        name: _faces_on(mesh, mesh.owners(name), parts, positions)
        for name, nodes in mesh.boundaries.items()
        if not on_axis[nodes].all()
    }


def _faces_on(mesh: Mesh, owners: np.ndarray, parts: Subdivision, positions: np.ndarray) -> Faces:
    """Faces of the particles' domains on facets of elements: cell and local facet number (k, 2)."""
    cells, facets = owners.T
    part = np.array([[face.part for face in facet] for facet in parts.faces])[facets]
    places = np.array([[parts.corners[f.part, list(f.corners)] for f in facet] for facet in parts.faces])
    particles = (cells[:, None] * len(parts.corners) + part).ravel()
    corners = np.empty((len(cells), *places.shape[1:]))
    for facet in np.unique(facets):
        mine = facets == facet
        local = places[facet].reshape(-1, mesh.dimension)
        corners[mine] = _mapped(mesh, local, cells[mine]).reshape(-1, *places.shape[1:])
    corners = corners.reshape(-1, *places.shape[2:])
    return Faces(particles, np.ascontiguousarray(corners - positions[particles][:, None]))

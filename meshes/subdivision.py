"""Elements cut into one part for each point of their full quadrature rule: what a point stands for."""

from functools import cache
from typing import NamedTuple

import numpy as np

from meshes.kinds import KINDS

GAUSS_POINTS = {"quad4": 2, "quad8": 3, "quad9": 3, "hex8": 2, "hex20": 3, "hex27": 3}
"""Points along each edge of quads and hexahedra; linear simplices have 1 in all, quadratic ones 1 at each vertex."""

ON_FACET = 1e-9


class Part(NamedTuple):
    """A face that a part has in common with a facet of its element: number of the part, and its corners there."""

    part: int
    corners: tuple[int, ...]


class Subdivision(NamedTuple):
    """Parts of the reference element.

    places (q, d), weights (q,) : of the quadrature rule, in scikit-fem's order. corners (q, 2^d, d) : of the part of
    each point, a quad counter-clockwise or a hexahedron in VTK's order; corners of triangles and tetrahedra repeat.
    faces : for each facet of the element the parts' faces that make it up, seen from outside, in 2-D head to tail.
    """

    places: np.ndarray
    weights: np.ndarray
    corners: np.ndarray
    faces: tuple[tuple[Part, ...], ...]


@cache
def subdivision(kind: str) -> Subdivision:
    """The parts of a kind of element for its full rule (see GAUSS_POINTS)."""
    if kind in GAUSS_POINTS:
        abscissas, weights = np.polynomial.legendre.leggauss(GAUSS_POINTS[kind])
        return _boxes(kind, 0.5 + 0.5 * abscissas, 0.5 * weights)
    return _simplices(kind)


@cache
def lattice(kind: str, along: int) -> Subdivision:
    """The parts of a kind of quad or hexahedron cut evenly, `along` parts along each edge; places are their middles."""
    return _boxes(kind, (np.arange(along) + 0.5) / along, np.full(along, 1.0 / along))


def _boxes(kind: str, abscissas: np.ndarray, weights: np.ndarray) -> Subdivision:
    """Parts as wide as the weights of a one-dimensional rule."""
    dimension = KINDS[kind].dimension
    ends = np.concatenate([[0.0], np.cumsum(weights)])
    ends[-1] = 1.0
    grid = np.meshgrid(*[np.arange(len(weights))] * dimension)
    numbers = np.column_stack([axis.ravel(order="F") for axis in grid])
    box = KINDS[_brick(dimension)].reference_nodes
    corners = ends[numbers][:, None] + box * (ends[numbers + 1] - ends[numbers])[:, None]
    return Subdivision(abscissas[numbers], weights[numbers].prod(axis=1), corners, _faces(kind, corners))


def _simplices(kind: str) -> Subdivision:
    """The whole simplex, or for quadratic kinds one part for each vertex, up to the middles of edges and faces."""
    from skfem import MeshTet, MeshTri
    from skfem.quadrature import get_quadrature

    vertices = KINDS[KINDS[kind].linear].reference_nodes
    dimension = vertices.shape[1]
    degenerate = [0, 1, 2, 2] if dimension == 2 else [0, 1, 2, 2, 3, 3, 3, 3]
    if KINDS[kind].degree == 1:
        corners = vertices[degenerate][None]
        volume = 1.0 / (2.0 if dimension == 2 else 6.0)
        return Subdivision(vertices.mean(axis=0)[None], np.array([volume]), corners, _faces(kind, corners))
    places, weights = get_quadrature((MeshTri if dimension == 2 else MeshTet).elem.refdom, 2)
    nearest = np.linalg.norm(places.T[:, None] - vertices, axis=2).argmin(axis=1)
    corners = np.stack([_corner_part(vertices, int(vertex)) for vertex in nearest])
    return Subdivision(np.ascontiguousarray(places.T), weights, corners, _faces(kind, corners))


def _corner_part(vertices: np.ndarray, vertex: int) -> np.ndarray:
    """Part of a simplex round a vertex: the vertex, middles of its edges and faces, and the middle of all."""
    others = [(vertex + k) % len(vertices) for k in range(1, len(vertices))]

    def middle(*numbers: int) -> np.ndarray:
        return vertices[[vertex, *numbers]].mean(axis=0)

    if len(others) == 2:
        a, b = others
        return np.array([vertices[vertex], middle(a), middle(a, b), middle(b)])
    a, b, c = others
    sides = vertices[[a, b, c]] - vertices[vertex]
    if np.linalg.det(sides) < 0.0:
        b, c = c, b
    return np.array(
        [
            vertices[vertex],
            middle(a),
            middle(a, b),
            middle(b),
            middle(c),
            middle(a, c),
            middle(a, b, c),
            middle(b, c),
        ]
    )


def _brick(dimension: int) -> str:
    return "quad4" if dimension == 2 else "hex8"


def _faces(kind: str, corners: np.ndarray) -> tuple[tuple[Part, ...], ...]:
    """For each facet of the reference element the faces of the parts that lie on it."""
    element = KINDS[kind]
    sides = KINDS[_brick(element.dimension)].facets
    found = []
    for facet in element.facets:
        ends = element.reference_nodes[list(facet)]
        normal = _normal(ends)
        on_facet = np.abs((corners - ends[0]) @ normal) < ON_FACET
        parts = [
            (corners[part, side[0]] @ (ends[1] - ends[0]), Part(part, tuple(side)))
            for part in range(len(corners))
            for side in sides
            if on_facet[part, list(side)].all() and _measure(corners[part, list(side)]) > ON_FACET
        ]
        found.append(tuple(part for _, part in sorted(parts, key=lambda item: item[0])))
    return tuple(found)


def _normal(ends: np.ndarray) -> np.ndarray:
    """A unit vector normal to a facet with these corners."""
    along = ends[1] - ends[0]
    normal = np.array([along[1], -along[0]]) if len(along) == 2 else np.cross(along, ends[2] - ends[0])
    return normal / np.linalg.norm(normal)


def _measure(corners: np.ndarray) -> float:
    """Length or area of a face."""
    if corners.shape[1] == 2:
        return float(np.linalg.norm(corners[1] - corners[0]))
    return 0.5 * float(np.linalg.norm(np.cross(corners[2] - corners[0], corners[3] - corners[1])))

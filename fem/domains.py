"""The part of an element that each of its points stands for, as polygons and hexahedra."""

import numpy as np

from fem.reference import shape_functions
from meshes.kinds import KINDS

_CUTS = {1: (0.0, 1.0), 2: (0.0, 0.5, 1.0), 3: (0.0, 5.0 / 18.0, 13.0 / 18.0, 1.0)}
"""Where an edge is cut for so many Gauss points, in proportion to their weights."""
_WHOLE = {2: (0, 1, 2, 2), 3: (0, 1, 2, 2, 3, 3, 3, 3)}
"""A simplex as a quad or hexahedron with corners that coincide."""


def domain_shape(kind: str, places: np.ndarray) -> np.ndarray:
    """Shape functions (q, c, a) at the corners of the domain of each point; places : (q, d) of the points."""
    corners = _of_simplex(kind, places) if KINDS[kind].simplex else _of_cube(places)
    flat = shape_functions(kind, corners.reshape(-1, places.shape[1]))[0]
    return flat.reshape(*corners.shape[:2], -1)


def _of_cube(places: np.ndarray) -> np.ndarray:
    """Boxes (q, c, d) of the points of a product rule in the unit square or cube."""
    dimension = places.shape[1]
    cuts = np.array(_CUTS[round(len(places) ** (1.0 / dimension))])
    box = np.searchsorted(cuts, places) - 1
    unit = KINDS["quad4" if dimension == 2 else "hex8"].reference_nodes.astype(int)
    return cuts[box[:, None, :] + unit[None]]


def _of_simplex(kind: str, places: np.ndarray) -> np.ndarray:
    """The whole simplex for one point, else for each the quarter or third at its corner: (q, c, d)."""
    dimension = places.shape[1]
    vertices = KINDS[kind].reference_nodes[: dimension + 1]
    if len(places) == 1:
        return vertices[list(_WHOLE[dimension])][None]
    nearest = np.linalg.norm(vertices[None] - places[:, None], axis=2).argmin(axis=1)
    return np.array([_at_corner(vertices, int(corner)) for corner in nearest])


def _at_corner(vertices: np.ndarray, corner: int) -> np.ndarray:
    """The part of a simplex next to one of its corners, cut through the middles of edges, faces and the whole."""
    others = [vertex for vertex in range(len(vertices)) if vertex != corner]
    if np.linalg.det(vertices[others] - vertices[corner]) < 0.0:
        others[:2] = others[1::-1]
    if len(others) == 2:
        i, j = others
        parts = [(corner,), (corner, i), (corner, i, j), (corner, j)]
    else:
        i, j, k = others
        parts = [
            (corner,), (corner, i), (corner, i, j), (corner, j),
            (corner, k), (corner, i, k), (corner, i, j, k), (corner, j, k),
        ]  # fmt: skip
    return np.array([vertices[list(part)].mean(axis=0) for part in parts])

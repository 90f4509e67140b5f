"""What a mesh file holds, whatever its format, and the mesh that it makes."""

from pathlib import Path
from typing import NamedTuple

import numpy as np

from core_models.errors import MeshError
from meshes.facets import find_facets
from meshes.kinds import FACET_NODES, KINDS, Kind
from meshes.mesh import Mesh

IN_PLANE = 1e-9
"""Largest third coordinate of a plane mesh, as a part of the largest coordinate."""

_REMEDY = "mesh with one kind of element"
_ONE_KIND = {
    2: f"{_REMEDY} (gmsh: quads by Recombine Surface and Mesh.RecombinationAlgorithm = 3, else triangles)",
    3: f"{_REMEDY} (gmsh: tetrahedra, or hexahedra by Transfinite Volume and Recombine Surface)",
}


class Block(NamedTuple):
    """Elements of one type, kinds' and facets' names as in `meshes.kinds`; others keep the file's own name."""

    type: str
    nodes: np.ndarray


class Named(NamedTuple):
    """What a file calls by one name: elements (block, row), faces of elements (block, row, facet), and nodes."""

    elements: np.ndarray = np.empty((0, 2), np.int64)
    faces: np.ndarray = np.empty((0, 3), np.int64)
    nodes: np.ndarray = np.empty(0, np.int64)


class Parsed(NamedTuple):
    """The contents of a mesh file: points (n, 2 or 3) [m], elements, and what has a name."""

    points: np.ndarray
    blocks: list[Block]
    named: dict[str, Named]


def to_mesh(path: Path, parsed: Parsed) -> Mesh:
    """The mesh of the elements of highest dimension; nodes that they do not use are left out.

    A name becomes a boundary by its faces, else by its elements that are facets of the mesh's elements, else by the
    facets of the rim all of whose nodes it holds; it becomes none when it has none of these.
    Raises MeshError, naming the file: no elements, or elements of several or unknown kinds, facets of another kind,
    2-D elements out of the plane of x and y, and whatever Mesh refuses.
    """
    kind = _kind_of(path, parsed.blocks)
    points = _plane(path, parsed.points) if kind.dimension == 2 else parsed.points
    _check_numbers(path, parsed)
    own = [i for i, block in enumerate(parsed.blocks) if block.type == kind.name]
    cells = np.concatenate([parsed.blocks[i].nodes for i in own])
    used, numbers = np.unique(cells, return_inverse=True)
    new_number = np.full(len(points), -1)
    new_number[used] = np.arange(len(used))
    cells = numbers.reshape(cells.shape)
    boundaries = {}
    for name, group in parsed.named.items():
        nodes = _by_faces(parsed.blocks, kind, group)
        if len(nodes) == 0:
            nodes = _by_elements(path, parsed.blocks, kind, name, group)
        nodes = new_number[nodes]
        if len(nodes) == 0 and len(group.nodes) and not np.isin(group.elements[:, 0], own).any():
            nodes = _by_nodes(points[used], cells, kind, new_number[group.nodes])
        if len(nodes):
            boundaries[name] = nodes
    return Mesh(points[used], kind.name, cells, boundaries, source=str(path))


def _kind_of(path: Path, blocks: list[Block]) -> Kind:
    """The one kind of the elements of highest dimension."""
    counts: dict[str, int] = {}
    for block in blocks:
        counts[block.type] = counts.get(block.type, 0) + len(block.nodes)
    for name in counts:
        if name not in KINDS and name not in FACET_NODES and name != "vertex":
            raise MeshError(
                f"{path}: holds cells of type {name}; mesh with one of {', '.join(KINDS)} "
                "(gmsh: Mesh.ElementOrder = 1 or 2)"
            )
    found = [KINDS[name] for name in counts if name in KINDS]
    dimension = max((kind.dimension for kind in found), default=0)
    kinds = [kind for kind in found if kind.dimension == dimension]
    if not kinds:
        raise MeshError(
            f"{path}: holds no elements of a body; export them too (gmsh: Physical Surface, or Physical Volume in 3-D)"
        )
    if len(kinds) > 1:
        several = " and ".join(f"{counts[kind.name]} {kind.name}" for kind in kinds)
        raise MeshError(f"{path}: holds {several} elements; {_ONE_KIND[dimension]}")
    return kinds[0]


def _check_numbers(path: Path, parsed: Parsed) -> None:
    """Raise MeshError when elements use nodes that the file does not hold."""
    for block in parsed.blocks:
        wrong = (block.nodes < 0) | (block.nodes >= len(parsed.points))
        if wrong.any():
            raise MeshError(
                f"{path}: {block.type} element {int(wrong.any(axis=1).argmax())} uses a node that is not there; "
                "export the file again"
            )


def _plane(path: Path, points: np.ndarray) -> np.ndarray:
    """The first two coordinates; raises MeshError when the third is not zero."""
    if points.shape[1] == 3 and np.abs(points[:, 2]).max() > IN_PLANE * np.abs(points).max():
        raise MeshError(
            f"{path}: 2-D elements do not lie in the plane of x and y; set every third coordinate to 0, "
            "or export the volume's elements too"
        )
    return points[:, :2]


def _by_faces(blocks: list[Block], kind: Kind, group: Named) -> np.ndarray:
    """Nodes (k, b) of the faces of the mesh's own elements in a group."""
    local = np.array(kind.facets)
    parts = [np.empty((0, local.shape[1]), np.int64)]
    for block, row, facet in group.faces:
        if blocks[block].type == kind.name:
            parts.append(blocks[block].nodes[row][local[facet]][None])
    return np.concatenate(parts)


def _by_elements(path: Path, blocks: list[Block], kind: Kind, name: str, group: Named) -> np.ndarray:
    """Nodes (k, b) of the elements of a group that have the dimension of facets."""
    parts = [np.empty((0, len(kind.facets[0])), np.int64)]
    for number in np.unique(group.elements[:, 0]):
        block = blocks[number]
        if (
            block.type == "vertex"
            or FACET_NODES.get(block.type, np.empty((0, 9))).shape[1] != kind.dimension - 1
        ):
            continue
        if block.type != kind.facet:
            raise MeshError(
                f"{path}: '{name}' holds {block.type} elements, but facets of {kind.name} elements are "
                f"{kind.facet}; mesh boundary and body together"
            )
        parts.append(block.nodes[group.elements[group.elements[:, 0] == number, 1]])
    return np.concatenate(parts)


def _by_nodes(points: np.ndarray, cells: np.ndarray, kind: Kind, nodes: np.ndarray) -> np.ndarray:
    """Nodes (k, b) of the facets of the rim that consist of the given nodes."""
    inside = np.zeros(len(points), dtype=bool)
    inside[nodes[nodes >= 0]] = True
    facets = cells[:, np.array(kind.facets)].reshape(-1, len(kind.facets[0]))
    if not inside[facets].all(axis=1).any():
        return np.empty((0, facets.shape[1]), np.int64)
    rim = find_facets(kind.name, points, cells)
    facets = rim.nodes[rim.rim()]
    return facets[inside[facets].all(axis=1)]

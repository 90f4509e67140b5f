"""The kinds of element: their nodes in VTK's order, their facets outwards, their names elsewhere."""

from dataclasses import dataclass, field
from itertools import product

import numpy as np

from core_models.errors import MeshError
from core_models.names import suggestion

_LINE = ((0, 1),)
_TRIANGLE = ((0, 1), (1, 2), (2, 0))
_QUAD = ((0, 1), (1, 2), (2, 3), (3, 0))
_TETRAHEDRON = ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3))
_HEXAHEDRON = (*_QUAD, (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7))
_TETRAHEDRON_FACES = ((0, 1, 3), (1, 2, 3), (2, 0, 3), (0, 2, 1))
_HEXAHEDRON_FACES = ((0, 4, 7, 3), (1, 2, 6, 5), (0, 1, 5, 4), (3, 7, 6, 2), (0, 3, 2, 1), (4, 5, 6, 7))

_CORNERS = {
    "line": [(0,), (1,)],
    "tri": [(0, 0), (1, 0), (0, 1)],
    "quad": [(0, 0), (1, 0), (1, 1), (0, 1)],
    "tet": [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)],
    "hex": [(x, y, z) for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))],
}


@dataclass(frozen=True, eq=False)
class Kind:
    """One kind of element.

    name : its key in KINDS. meshio, skfem : its names there (skfem: of the class of its shape functions).
    dimension : 2 or 3. nodes, corners : numbers of all nodes and of those at vertices; corners come first.
    degree : 1 or 2. simplex : whether it is a triangle or tetrahedron. facet : name of its facets' kind.
    facets : local nodes of each facet, in VTK's order of the facet's kind, seen from outside (2-D: with the body on
    the left). reference_nodes (nodes, dimension) : in the unit square or cube, or the unit simplex.
    """

    name: str
    meshio: str
    skfem: str
    dimension: int
    corners: int
    degree: int
    simplex: bool
    facet: str
    facets: tuple[tuple[int, ...], ...]
    reference_nodes: np.ndarray = field(repr=False)

    @property
    def nodes(self) -> int:
        """Number of nodes."""
        return len(self.reference_nodes)

    @property
    def linear(self) -> str:
        """Name of the kind of the same shape with nodes at corners only."""
        return f"{_shape_of(self.name)}{self.corners}"


def find_kind(name: str, dimension: int | None = None) -> Kind:
    """The kind of this name, in any or the given dimension; MeshError with the nearest name otherwise."""
    valid = [kind.name for kind in KINDS.values() if dimension in (None, kind.dimension)]
    if name not in valid:
        where = "" if dimension is None else f" in {dimension}-D"
        raise MeshError(f"no kind of element '{name}'{where}; {suggestion(name, valid)}")
    return KINDS[name]


def _shape_of(name: str) -> str:
    return name.rstrip("0123456789")


def _middle(corners: np.ndarray, locals_: tuple[tuple[int, ...], ...]) -> np.ndarray:
    return np.array([corners[list(nodes)].mean(axis=0) for nodes in locals_])


def _reference_nodes(name: str, edges: tuple, faces: tuple = (), centre: bool = False) -> np.ndarray:
    corners = np.array(_CORNERS[_shape_of(name)], dtype=float)
    parts = [corners]
    if edges:
        parts.append(_middle(corners, edges))
    if faces:
        parts.append(_middle(corners, faces))
    if centre:
        parts.append(corners.mean(axis=0, keepdims=True))
    nodes = np.concatenate(parts)
    nodes.flags.writeable = False
    return nodes


FACET_NODES: dict[str, np.ndarray] = {
    "line2": _reference_nodes("line2", ()),
    "line3": _reference_nodes("line3", _LINE),
    "tri3": _reference_nodes("tri3", ()),
    "tri6": _reference_nodes("tri6", _TRIANGLE),
    "quad4": _reference_nodes("quad4", ()),
    "quad8": _reference_nodes("quad8", _QUAD),
    "quad9": _reference_nodes("quad9", _QUAD, centre=True),
}
"""Reference nodes (b, dimension of the facet) of the kinds of facets."""


def _facet_nodes(nodes: np.ndarray, corners: tuple[int, ...], facet: str) -> tuple[int, ...]:
    """Local nodes of a facet in VTK's order: those that lie where the facet's own nodes are mapped to."""
    vertices = nodes[list(corners)]
    along = vertices[[1, -1]] - vertices[0] if len(corners) > 2 else vertices[1:] - vertices[0]
    places = vertices[0] + FACET_NODES[facet] @ along
    return tuple(int(np.abs(nodes - place).max(axis=1).argmin()) for place in places)


def _kind(name: str, meshio: str, skfem: str, facet: str, faces: tuple, nodes: np.ndarray) -> Kind:
    shape = _shape_of(name)
    return Kind(
        name=name,
        meshio=meshio,
        skfem=skfem,
        dimension=nodes.shape[1],
        corners=len(_CORNERS[shape]),
        degree=1 if len(nodes) == len(_CORNERS[shape]) else 2,
        simplex=shape in ("tri", "tet"),
        facet=facet,
        facets=tuple(_facet_nodes(nodes, corners, facet) for corners in faces),
        reference_nodes=nodes,
    )


_VTK_FACE_CENTRES = _HEXAHEDRON_FACES  # VTK numbers them x = 0, x = 1, y = 0, y = 1, z = 0, z = 1

KINDS: dict[str, Kind] = {
    kind.name: kind
    for kind in (
        _kind("quad4", "quad", "ElementQuad1", "line2", _QUAD, FACET_NODES["quad4"]),
        _kind("quad8", "quad8", "ElementQuadS2", "line3", _QUAD, FACET_NODES["quad8"]),
        _kind("quad9", "quad9", "ElementQuad2", "line3", _QUAD, FACET_NODES["quad9"]),
        _kind("tri3", "triangle", "ElementTriP1", "line2", _TRIANGLE, FACET_NODES["tri3"]),
        _kind("tri6", "triangle6", "ElementTriP2", "line3", _TRIANGLE, FACET_NODES["tri6"]),
        _kind("hex8", "hexahedron", "ElementHex1", "quad4", _HEXAHEDRON_FACES, _reference_nodes("hex8", ())),
        _kind(
            "hex20",
            "hexahedron20",
            "ElementHexS2",
            "quad8",
            _HEXAHEDRON_FACES,
            _reference_nodes("hex20", _HEXAHEDRON),
        ),
        _kind(
            "hex27",
            "hexahedron27",
            "ElementHex2",
            "quad9",
            _HEXAHEDRON_FACES,
            _reference_nodes("hex27", _HEXAHEDRON, _VTK_FACE_CENTRES, centre=True),
        ),
        _kind("tet4", "tetra", "ElementTetP1", "tri3", _TETRAHEDRON_FACES, _reference_nodes("tet4", ())),
        _kind(
            "tet10",
            "tetra10",
            "ElementTetP2",
            "tri6",
            _TETRAHEDRON_FACES,
            _reference_nodes("tet10", _TETRAHEDRON),
        ),
    )
}
"""The ten kinds of element by name."""


def monomials(name: str) -> np.ndarray:
    """Exponents (nodes, dimension) of the monomials that span a kind's shape functions.

    Simplices: total degree up to that of the kind. Others: each exponent up to the degree; of quad8 and hex20
    (serendipity) those with at most one exponent of 2.
    """
    kind = KINDS[name]
    exponents = np.array(list(product(range(kind.degree + 1), repeat=kind.dimension)))
    if kind.simplex:
        return exponents[exponents.sum(axis=1) <= kind.degree]
    if name in ("quad8", "hex20"):
        return exponents[(exponents == 2).sum(axis=1) <= 1]
    return exponents

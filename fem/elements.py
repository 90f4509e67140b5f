"""Elements as kernels see them: how many nodes and points, at compile time for those that have to be fast."""

from typing import NamedTuple

from core_models.dispatch import generic
from core_models.errors import SceneError
from core_models.names import suggestion
from meshes.kinds import KINDS

FULL, REDUCED = "full", "reduced"
MOST_POINTS = 27
_POINTS = {
    "quad4": 4, "quad8": 9, "quad9": 9, "tri3": 1, "tri6": 3,
    "hex8": 8, "hex20": 27, "hex27": 27, "tet4": 1, "tet10": 4,
}  # fmt: skip
_REDUCED_POINTS = {"quad4": 1, "hex8": 1, "quad8": 4, "hex20": 8}


class BilinearQuad(NamedTuple):
    """quad4 with 2 x 2 points."""


class TrilinearHexahedron(NamedTuple):
    """hex8 with 2 x 2 x 2 points."""


class Sized(NamedTuple):
    """Any element: numbers of nodes and points, known at run time."""

    nodes: int
    points: int


Element = BilinearQuad | TrilinearHexahedron | Sized


@generic
def nodes_of(element):
    """Nodes of an element."""


@generic
def points_of(element):
    """Quadrature points of an element."""


@nodes_of.register(BilinearQuad)
def _(element):
    return 4


@points_of.register(BilinearQuad)
def _(element):
    return 4


@nodes_of.register(TrilinearHexahedron)
def _(element):
    return 8


@points_of.register(TrilinearHexahedron)
def _(element):
    return 8


@nodes_of.register(Sized)
def _(element):
    return element.nodes


@points_of.register(Sized)
def _(element):
    return element.points


def find_element(kind: str, integration: str) -> Element:
    """The element of a kind with full or reduced integration.

    Raises SceneError for an unknown integration, or a reduced one that the kind does not have.
    """
    if integration not in (FULL, REDUCED):
        raise SceneError(
            f"no integration is called {integration!r}; {suggestion(integration, (FULL, REDUCED))}"
        )
    if integration == REDUCED and kind not in _REDUCED_POINTS:
        raise SceneError(
            f"{kind} has no reduced integration, only {', '.join(_REDUCED_POINTS)} have: use integration='full'"
        )
    if integration == FULL and kind in ("quad4", "hex8"):
        return BilinearQuad() if kind == "quad4" else TrilinearHexahedron()
    points = _POINTS[kind] if integration == FULL else _REDUCED_POINTS[kind]
    return Sized(KINDS[kind].nodes, points)


def is_one_point_brick(kind: str, integration: str) -> bool:
    """Whether the element is a quad or hexahedron with one point, which needs hourglass control."""
    return integration == REDUCED and kind in ("quad4", "hex8")

"""Reference elements: scikit-fem's shape functions in VTK's order of nodes, and quadrature rules."""

import numpy as np

from meshes.kinds import FACET_NODES, KINDS

_FACETS = {
    "line2": "ElementLineP1",
    "line3": "ElementLineP2",
    "tri3": "ElementTriP1",
    "tri6": "ElementTriP2",
    "quad4": "ElementQuad1",
    "quad8": "ElementQuadS2",
    "quad9": "ElementQuad2",
}
_TO_DEGREE = {"line2": 3, "line3": 5, "quad4": 3, "quad8": 5, "quad9": 5, "hex8": 3, "hex20": 5, "hex27": 5}
_SIMPLEX_TO_DEGREE = {"tri6": 2, "tet10": 2}


def shape_functions(kind: str, places: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Shape functions (q, a) and their gradients (q, a, d) at reference coordinates (q, d) of a kind or a facet."""
    import skfem

    nodes = KINDS[kind].reference_nodes if kind in KINDS else FACET_NODES[kind]
    element = getattr(skfem, KINDS[kind].skfem if kind in KINDS else _FACETS[kind])()
    distance = np.abs(nodes[:, None, :] - element.doflocs[None]).max(axis=2)
    found = [element.lbasis(places.T, int(number)) for number in distance.argmin(axis=1)]
    values = np.array([np.broadcast_to(value, len(places)) for value, _ in found]).T
    gradients = np.array([np.broadcast_to(gradient, places.T.shape) for _, gradient in found])
    return np.ascontiguousarray(values), np.ascontiguousarray(gradients.transpose(2, 0, 1))


def rule(kind: str, degree: int | None = None) -> tuple[np.ndarray, np.ndarray]:
    """Quadrature points (q, d) and weights (q,) on the reference cell of a kind or facet.

    degree : of polynomials to be exact for; by default that of the element's own rule: 2 points along each edge of
    linear quads and hexahedra, 3 of quadratic ones, 1 point in linear simplices, 3 or 4 in tri6 and tet10.
    """
    import skfem
    from skfem.quadrature import get_quadrature

    nodes = KINDS[kind].reference_nodes if kind in KINDS else FACET_NODES[kind]
    if degree is None and kind in ("tri3", "tet4"):
        volume = 1.0 / (2.0 if kind == "tri3" else 6.0)
        return nodes.mean(axis=0, keepdims=True), np.array([volume])
    wanted = degree or _TO_DEGREE.get(kind) or _SIMPLEX_TO_DEGREE[kind]
    name = KINDS[kind].skfem if kind in KINDS else _FACETS[kind]
    places, weights = get_quadrature(getattr(skfem, name)().refdom, wanted)
    return np.ascontiguousarray(places.T), np.ascontiguousarray(weights)

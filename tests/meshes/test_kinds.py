"""Kinds of element: their nodes, facets and shape functions."""

import numpy as np
import pytest

from core_models.errors import MeshError
from meshes.jacobians import check_places
from meshes.kinds import FACET_NODES, KINDS, find_kind
from meshes.measure import quadrature
from meshes.shape_functions import shape_gradients, shape_values

VTK_CLASSES = {
    "quad4": "Quad",
    "quad8": "QuadraticQuad",
    "quad9": "BiQuadraticQuad",
    "tri3": "Triangle",
    "tri6": "QuadraticTriangle",
    "hex8": "Hexahedron",
    "hex20": "QuadraticHexahedron",
    "hex27": "TriQuadraticHexahedron",
    "tet4": "Tetra",
    "tet10": "QuadraticTetra",
}


@pytest.mark.parametrize("name", KINDS)
def test_nodes_have_vtks_order(name):
    """Reference nodes are the parametric coordinates of VTK's cells, in their order."""
    vtk = pytest.importorskip("vtkmodules.vtkCommonDataModel")
    cell = getattr(vtk, f"vtk{VTK_CLASSES[name]}")()
    kind = KINDS[name]
    found = np.zeros((kind.nodes, 3))
    for node in range(kind.nodes):
        weights = [0.0] * kind.nodes
        cell.InterpolateFunctions([*kind.reference_nodes[node], 0.0][:3], weights)
        found[node, 0] = np.argmax(weights)
    assert found[:, 0].astype(int).tolist() == list(range(kind.nodes))


@pytest.mark.parametrize("name", KINDS)
def test_nodes_are_those_of_scikit_fems_element(name):
    """The scikit-fem element of a kind has its degrees of freedom at the kind's nodes, in another order."""
    import skfem

    theirs = getattr(skfem, KINDS[name].skfem)().doflocs
    assert sorted(map(tuple, theirs.tolist())) == sorted(map(tuple, KINDS[name].reference_nodes.tolist()))


@pytest.mark.parametrize("name", KINDS)
def test_shape_functions_are_one_at_their_node_and_sum_to_one(name):
    """N_a is 1 at node a and 0 at the others; everywhere sum N_a = 1, sum x_a N_a = x and sum dN_a = 0."""
    kind = KINDS[name]
    assert np.array_equal(shape_values(name, kind.reference_nodes), np.eye(kind.nodes))
    places = np.random.default_rng(0).random((20, kind.dimension))
    assert np.allclose(shape_values(name, places) @ kind.reference_nodes, places, atol=1e-13)
    slopes = np.einsum("qak,ai->qik", shape_gradients(name, places), kind.reference_nodes)
    assert np.allclose(slopes, np.eye(kind.dimension), atol=1e-13)
    assert np.abs(shape_gradients(name, places).sum(axis=1)).max() < 1e-13


@pytest.mark.parametrize("name", KINDS)
def test_facets_hold_the_nodes_of_their_kind_in_its_order(name):
    """A facet's nodes lie where its kind has them; all lie on one side of the cell."""
    kind = KINDS[name]
    for facet in kind.facets:
        nodes = kind.reference_nodes[list(facet)]
        if KINDS.get(kind.facet):
            weights = shape_values(KINDS[kind.facet].linear, FACET_NODES[kind.facet])
        else:
            weights = np.column_stack([1.0 - FACET_NODES[kind.facet], FACET_NODES[kind.facet]])
        assert np.allclose(weights @ nodes[: weights.shape[1]], nodes, atol=1e-15)
    assert len(set(map(frozenset, kind.facets))) == len(kind.facets)


@pytest.mark.parametrize("name", KINDS)
def test_reference_cell_is_measured_exactly(name):
    """The weights sum to the measure of the reference cell, and its first moments to that times its middle."""
    places, weights = quadrature(name)
    exact = {True: {2: 0.5, 3: 1.0 / 6.0}, False: {2: 1.0, 3: 1.0}}[KINDS[name].simplex][
        KINDS[name].dimension
    ]
    middle = KINDS[name].reference_nodes[: KINDS[name].corners].mean(axis=0)
    assert weights.sum() == pytest.approx(exact, rel=1e-14)
    assert np.allclose(weights @ places, exact * middle, rtol=1e-14)


def test_check_places_of_serendipity_elements_include_their_middles():
    """The maps of quad8 and hex20 are checked in the middles of faces and cell too, where they have no node."""
    assert len(check_places("quad8")) == 9 and len(check_places("hex20")) == 27


@pytest.mark.parametrize(
    ("name", "dimension", "told"), [("hex", None, "did you mean 'hex"), ("hex8", 2, "in 2-D")]
)
def test_unknown_kinds_are_refused(name, dimension, told):
    """A wrong kind comes with the nearest name, and those of the dimension."""
    with pytest.raises(MeshError, match=told):
        find_kind(name, dimension)

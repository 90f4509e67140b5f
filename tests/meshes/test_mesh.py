"""What a mesh must be, and what it says when it is not."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from core_models.errors import MeshError
from meshes.block import block
from meshes.boundaries import require_boundaries
from meshes.facets import facet_vectors, find_facets
from meshes.kinds import KINDS
from meshes.mesh import Mesh
from meshes.quality import quality


def four_quads():
    """Points, cells and boundaries of 2 x 2 quads, x and y from 0 to 2."""
    points = np.array([[x, y] for y in range(3) for x in range(3)], dtype=float)
    cells = np.array([[0, 1, 4, 3], [1, 2, 5, 4], [3, 4, 7, 6], [4, 5, 8, 7]])
    boundaries = {
        "bottom": np.array([[0, 1], [1, 2]]),
        "right": np.array([[2, 5], [5, 8]]),
        "top": np.array([[8, 7], [7, 6]]),
        "left": np.array([[6, 3], [3, 0]]),
    }
    return points, cells, boundaries


def refusal(points, cells, boundaries, kind="quad4"):
    """The one line with which a mesh is refused."""
    with pytest.raises(MeshError) as caught:
        Mesh(points, kind, cells, boundaries, source="plate.msh")
    message = str(caught.value)
    assert message.startswith("plate.msh: ") and "\n" not in message
    return message


def unit(kind, counts=2, **options):
    """A unit square or cube."""
    dimension = KINDS[kind].dimension
    return block([0.0] * dimension, [1.0] * dimension, [counts] * dimension, kind, **options)


@given(st.permutations(range(2)), st.lists(st.booleans(), min_size=2, max_size=2))
def test_boundary_edges_are_put_in_order(order, flips):
    """Edges may come in any order and direction; they leave head to tail, with the body on their left."""
    points, cells, boundaries = four_quads()
    mixed = {
        name: np.array([pairs[i][::-1] if flip else pairs[i] for i, flip in zip(order, flips, strict=True)])
        for name, pairs in boundaries.items()
    }
    mesh = Mesh(points, "quad4", cells, mixed)
    assert {name: pairs.tolist() for name, pairs in mesh.boundaries.items()} == {
        name: pairs.tolist() for name, pairs in boundaries.items()
    }


@pytest.mark.parametrize("kind", KINDS)
def test_boundary_facets_may_be_given_by_their_corners_in_any_order(kind):
    """Facets get all their nodes, outwards, whatever order and direction they come in; the order of facets stays."""
    mesh = unit(kind)
    corners = 2 if mesh.dimension == 2 else KINDS[KINDS[kind].facet].corners
    shuffle = np.random.default_rng(0).permutation(corners)
    bare = {name: nodes[:, :corners][:, shuffle] for name, nodes in mesh.boundaries.items()}
    again = Mesh(mesh.points, kind, mesh.cells, bare)
    for name, nodes in mesh.boundaries.items():
        assert np.array_equal(again.boundaries[name], nodes)


@pytest.mark.parametrize("kind", KINDS)
def test_owners_are_the_cells_of_the_facets(kind):
    """Cell and local number of a facet lead back to the facet's nodes."""
    mesh = unit(kind)
    local = np.array(KINDS[kind].facets)
    for name, nodes in mesh.boundaries.items():
        cell, facet = mesh.owners(name).T
        assert np.array_equal(mesh.cells[cell[:, None], local[facet]], nodes)


@pytest.mark.parametrize("kind", KINDS)
def test_boundary_facets_point_outwards(kind):
    """The facet vectors of a block are the outward normals of its sides, and sum to their areas and to zero."""
    mesh = unit(kind)
    facets = find_facets(kind, mesh.points, mesh.cells)
    total = np.zeros(mesh.dimension)
    for name, normal in (
        ("left", [-1, 0, 0]),
        ("right", [1, 0, 0]),
        ("front", [0, -1, 0]),
        ("back", [0, 1, 0]),
    ):
        if name in mesh.boundaries:
            vectors = facet_vectors(mesh.points[mesh.boundaries[name][:, : facets.corners]])
            assert np.allclose(vectors.sum(axis=0), normal[: mesh.dimension], atol=1e-14)
    total = facet_vectors(mesh.points[facets.nodes[facets.rim()][:, : facets.corners]]).sum(axis=0)
    assert np.abs(total).max() < 1e-14


@given(st.integers(0, 3), st.floats(-0.9, 0.9), st.floats(-0.9, 0.9))
def test_every_accepted_element_has_a_positive_map(element, dx, dy):
    """A moved inner node gives either a mesh of convex elements or an error that names an element."""
    points, cells, boundaries = four_quads()
    points[4] += (dx, dy)
    try:
        mesh = Mesh(points, "quad4", cells[np.roll(range(4), element)], boundaries)
    except MeshError as error:
        assert "element" in str(error)
        return
    assert quality(mesh).min_scaled_jacobian > 0.0


def test_inverted_element_is_named():
    """The number, the place and the remedy of an inverted element are in the message."""
    points, cells, boundaries = four_quads()
    points[4] = (1.9, 1.9)
    message = refusal(points, cells, boundaries)
    assert "element 3 (counted from 0; the only one) near (1.725, 1.725) m is inverted" in message
    assert "remesh" in message


@pytest.mark.parametrize("kind", ["quad4", "tri6", "hex8", "tet10"])
def test_elements_the_wrong_way_round_are_told_from_inverted_ones(kind):
    """A mesh drawn the wrong way round is said to be, with the count and the cure."""
    mesh = unit(kind)
    flipped = mesh.points.copy()
    flipped[:, 0] *= -1.0
    message = refusal(flipped, mesh.cells, {}, kind)
    assert f"element 0 (counted from 0; the first of {len(mesh.cells)})" in message
    assert ("clockwise; reverse" if mesh.dimension == 2 else "inside out; reverse") in message


def test_collapsed_element_is_refused():
    """Two nodes in one place make an element without a corner, which is refused."""
    points, cells, boundaries = four_quads()
    points[4] = points[1]
    assert "element 0" in refusal(points, cells, boundaries)


def test_middle_node_that_folds_its_element_is_refused():
    """A quadratic element whose middle node lies too near a corner folds over there."""
    mesh = unit("quad9", 1)
    points = mesh.points.copy()
    points[mesh.boundaries["bottom"][0, 2]] = (0.2, 0.0)
    assert "element 0" in refusal(points, mesh.cells, {}, "quad9")


def test_missing_boundary_is_named_with_the_nearest():
    """Asking for a boundary that is not there shows the nearest name in the mesh."""
    with pytest.raises(MeshError, match="'botom' is missing; did you mean 'bottom'"):
        require_boundaries(unit("quad4"), ["top", "botom"])


def test_mesh_without_names_says_how_to_give_them():
    """Without any named boundary the message says how gmsh names one."""
    points, cells, _ = four_quads()
    with pytest.raises(MeshError, match="no boundary has a name; name its facets"):
        require_boundaries(Mesh(points, "quad4", cells, {}), ["top"])


def test_named_facet_inside_the_body_is_refused():
    """A boundary facet lies on the rim."""
    points, cells, boundaries = four_quads()
    boundaries["bottom"] = np.vstack([boundaries["bottom"], [[1, 4]]])
    assert "from (1, 0) to (1, 1) m of 'bottom' is not on the rim" in refusal(points, cells, boundaries)


def test_named_facet_of_no_cell_is_refused():
    """A boundary facet belongs to a cell, and its nodes are there."""
    points, cells, boundaries = four_quads()
    assert "of 'bottom' belongs to no cell" in refusal(points, cells, boundaries | {"bottom": [[0, 2]]})
    assert "of nodes 0, 99 of 'top' belongs to no cell" in refusal(points, cells, {"top": [[0, 99]]})
    assert "of nodes -1, 0 of 'top' belongs to no cell" in refusal(points, cells, {"top": [[-1, 0]]})
    assert "and type float64" in refusal(points, cells, {"top": [[0.0, 1.0]]})
    assert "shape (0,) and type float64, not whole numbers (k, 2)" in refusal(points, cells, {"top": []})


def test_overlapping_cells_are_refused():
    """A facet belongs to two cells at most, which lie on its two sides."""
    points, cells, boundaries = four_quads()
    corners = np.array([[0, 0], [1, 0], [0, 1], [0.2, 0.3]])
    assert "same side of the facet from (0, 0) to (1, 0)" in refusal(
        corners, np.array([[0, 1, 2], [0, 1, 3]]), {}, "tri3"
    )
    points = np.vstack([points, [[-1.0, 0.0], [-1.0, 1.0]]])
    extra = [[9, 0, 3, 10]]
    assert "more than two" in refusal(points, np.vstack([cells, extra, extra]), boundaries)


def test_bad_numbers_are_refused():
    """Points that are not finite, nodes out of range or unused, wrong shapes and kinds."""
    points, cells, boundaries = four_quads()
    assert "node 9 belongs to no element" in refusal(np.vstack([points, [[9, 9]]]), cells, boundaries)
    assert "element 3 uses a node that is not there" in refusal(points[:8], cells, boundaries)
    assert "shape (4, 3) and type int64, not whole numbers (m, 4)" in refusal(
        points, cells[:, :3], boundaries
    )
    assert "type float64" in refusal(points, cells * 1.0, boundaries)
    assert "shape (9, 1), not (n, 2)" in refusal(points[:, :1], cells, boundaries)
    assert "no kind of element 'quad'; did you mean 'quad" in refusal(points, cells, boundaries, "quad")
    points[3, 1] = np.nan
    assert "node 3 has the coordinates [0.0, nan]" in refusal(points, cells, boundaries)


def test_quality_figures_of_a_known_mesh():
    """Figures of one parallelogram beside the axis, by hand."""
    points = np.array([[0, 0], [1, 1], [1, 3], [0, 2]], dtype=float)
    figures = quality(Mesh(points, "quad4", np.array([[0, 1, 2, 3]]), {}))
    assert figures.min_scaled_jacobian == pytest.approx(np.sqrt(0.5))
    assert figures.max_aspect_ratio == pytest.approx(np.sqrt(2.0))
    assert (figures.min_edge, figures.total) == pytest.approx((np.sqrt(2.0), 2.0))
    assert figures.turn == pytest.approx(2 * np.pi * 0.5 * 2.0)

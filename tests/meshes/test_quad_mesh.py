"""What a mesh must be, and what it says when it is not."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from core_models.errors import MeshError
from meshes.quad_mesh import QuadMesh
from meshes.quality import quality
from meshes.taylor_bar import taylor_bar


def block():
    """Points, quads and boundaries of a bar of 2 x 2 elements, r and z from 0 to 2."""
    points = np.array([[r, z] for z in range(3) for r in range(3)], dtype=float)
    quads = np.array([[0, 1, 4, 3], [1, 2, 5, 4], [3, 4, 7, 6], [4, 5, 8, 7]])
    boundaries = {
        "foot": np.array([[0, 1], [1, 2]]),
        "side": np.array([[2, 5], [5, 8]]),
        "rear": np.array([[8, 7], [7, 6]]),
        "axis": np.array([[6, 3], [3, 0]]),
    }
    return points, quads, boundaries


def refusal(points, quads, boundaries):
    """The one line with which a mesh is refused."""
    with pytest.raises(MeshError) as caught:
        QuadMesh(points, quads, boundaries, source="bar.msh")
    message = str(caught.value)
    assert message.startswith("bar.msh: ") and "\n" not in message
    return message


@given(st.permutations(range(2)), st.lists(st.booleans(), min_size=2, max_size=2))
def test_boundary_pairs_are_put_in_order(order, flips):
    """Pairs may come in any order and direction; they leave head to tail, counter-clockwise."""
    points, quads, boundaries = block()
    mixed = {
        name: np.array([pairs[i][::-1] if flip else pairs[i] for i, flip in zip(order, flips, strict=True)])
        for name, pairs in boundaries.items()
    }
    mesh = QuadMesh(points, quads, mixed)
    assert {name: pairs.tolist() for name, pairs in mesh.boundaries.items()} == {
        name: pairs.tolist() for name, pairs in boundaries.items()
    }


@given(st.integers(0, 3), st.floats(-0.9, 0.9), st.floats(-0.9, 0.9))
def test_every_accepted_element_has_a_positive_map(element, dr, dz):
    """A moved inner node gives either a mesh of convex elements or an error that names an element."""
    points, quads, boundaries = block()
    points[4] += (dr, dz)
    try:
        mesh = QuadMesh(points, quads[np.roll(range(4), element)], boundaries)
    except MeshError as error:
        assert "element" in str(error)
        return
    assert quality(mesh).min_scaled_jacobian > 0.0


def test_inverted_element_is_named():
    """The number, the place and the remedy of an inverted element are in the message."""
    points, quads, boundaries = block()
    points[4] = (1.9, 1.9)
    message = refusal(points, quads, boundaries)
    assert "element 3 (counted from 0; the only one) near r = 1.725 m, z = 1.725 m is inverted" in message
    assert "remesh" in message


def test_clockwise_elements_are_told_from_inverted_ones():
    """A mesh drawn the wrong way round is said to be clockwise, with the count and the cure."""
    points, quads, boundaries = block()
    message = refusal(points, quads[:, ::-1], boundaries)
    assert "element 0 (counted from 0; the first of 4)" in message
    assert "clockwise; reverse its nodes" in message


def test_collapsed_element_is_refused():
    """Two nodes in one place make an element without a corner, which is refused."""
    points, quads, boundaries = block()
    points[4] = points[1]
    assert "element 0" in refusal(points, quads, boundaries)


@pytest.mark.parametrize("name", ["foot", "side", "rear", "axis"])
def test_missing_boundary_is_named_with_the_nearest(name):
    """A misspelt boundary is missing, and the message shows the nearest name in the mesh."""
    points, quads, boundaries = block()
    boundaries[f"{name}_1"] = boundaries.pop(name)
    assert f"boundary '{name}' is missing (the nearest name there is '{name}_1')" in refusal(
        points, quads, boundaries
    )


def test_mesh_without_names_says_how_to_give_them():
    """Without any named boundary the message says how gmsh names one."""
    points, quads, _ = block()
    assert "named are: none); name the boundary edges" in refusal(points, quads, {})


def test_unnamed_boundary_edge_is_refused():
    """Every edge of the rim belongs to a boundary."""
    points, quads, boundaries = block()
    boundaries["side"] = boundaries["side"][:1]
    assert "from (r, z) = (2, 1) m to (2, 2) m has no name" in refusal(points, quads, boundaries)


def test_edge_with_two_names_is_refused():
    """No edge belongs to two boundaries."""
    points, quads, boundaries = block()
    boundaries["side"] = np.vstack([boundaries["side"], [[1, 2]]])
    assert "is in both 'foot' and 'side'" in refusal(points, quads, boundaries)


def test_named_edge_inside_the_body_is_refused():
    """A boundary edge lies on the rim."""
    points, quads, boundaries = block()
    boundaries["foot"] = np.vstack([boundaries["foot"], [[1, 4]]])
    assert "of 'foot' is not on the rim" in refusal(points, quads, boundaries)


def test_wrong_sequence_of_boundaries_is_refused():
    """Rear and foot may not be exchanged round the body's loop."""
    points, quads, boundaries = block()
    boundaries["side"], boundaries["rear"] = boundaries["rear"], boundaries["side"]
    assert "as foot, rear, side, axis, not as foot, side, rear, axis" in refusal(points, quads, boundaries)


def test_bar_drawn_along_x_is_refused():
    """An axis that is not on r = 0 is refused, saying which coordinate is which."""
    points, quads, boundaries = block()
    turned = np.column_stack([points[:, 1], 2.0 - points[:, 0]])
    quads = quads[:, [1, 2, 3, 0]]
    message = refusal(turned, quads, boundaries)
    assert "'axis'; the axis is exactly the edges on r = 0 (r is x, z is y)" in message


def test_nodes_of_the_axis_are_put_on_it_exactly():
    """Round-off in r on the axis is removed, so that no radius is negative."""
    points, quads, boundaries = block()
    points[[0, 3, 6], 0] = (-1e-12, 1e-12, 0.0)
    assert (QuadMesh(points, quads, boundaries).points[[0, 3, 6], 0] == 0.0).all()


def test_crack_is_refused():
    """Coinciding nodes that are not merged leave a crack; the message says to merge them."""
    points, quads, boundaries = block()
    points = np.vstack([points, points[[1]]])
    quads[0] = [0, 9, 4, 3]
    boundaries["foot"][0] = [0, 9]
    message = refusal(points, quads, boundaries)
    assert "from (r, z) = (1, 0) m to (1, 1) m has no name" in message
    assert "merge nodes that coincide" in message


def test_hole_is_refused():
    """A ring of elements round a hole has two loops of boundary edges."""
    bar = taylor_bar(3.0, 3.0, 3, 3)
    assert "merge nodes that coincide" in refusal(bar.points, np.delete(bar.quads, 4, axis=0), bar.boundaries)


def test_overlapping_elements_are_refused():
    """An edge belongs to two elements at most."""
    points, quads, boundaries = block()
    assert "more than two quads" in refusal(points, np.vstack([quads, quads[:1]]), boundaries)


def test_bad_numbers_are_refused():
    """Points that are not finite, radii below zero, nodes out of range or unused, wrong shapes."""
    points, quads, boundaries = block()
    assert "node 9 belongs to no element" in refusal(np.vstack([points, [[9, 9]]]), quads, boundaries)
    assert "element 3 uses a node that is not there" in refusal(points[:8], quads, boundaries)
    assert "shape (4, 3), not (m, 4)" in refusal(points, quads[:, :3], boundaries)
    assert "shape (9, 1), not (n, 2)" in refusal(points[:, :1], quads, boundaries)
    assert "move the body to r >= 0" in refusal(points - [0.5, 0.0], quads, boundaries)
    points[3, 1] = np.nan
    assert "node 3 has the coordinates [0.0, nan]" in refusal(points, quads, boundaries)


def test_scikit_fem_gets_the_same_mesh():
    """Numbers of nodes and elements and the boundaries' edges are the same in scikit-fem."""
    mesh = taylor_bar(1.0, 3.0, 3, 5)
    fem = mesh.to_skfem()
    assert np.array_equal(fem.p.T, mesh.points) and np.array_equal(fem.t.T, mesh.quads)
    for name, pairs in mesh.boundaries.items():
        assert np.array_equal(fem.facets[:, fem.boundaries[name]].T, np.sort(pairs, axis=1))


def test_quality_figures_of_a_known_mesh():
    """Figures of one parallelogram beside the axis, by hand."""
    points = np.array([[0, 0], [1, 1], [1, 3], [0, 2]], dtype=float)
    boundaries = dict(
        zip(("foot", "side", "rear", "axis"), [[[0, 1]], [[1, 2]], [[2, 3]], [[3, 0]]], strict=True)
    )
    figures = quality(QuadMesh(points, np.array([[0, 1, 2, 3]]), boundaries))
    assert figures.min_scaled_jacobian == pytest.approx(np.sqrt(0.5))
    assert figures.max_aspect_ratio == pytest.approx(np.sqrt(2.0))
    assert (figures.min_edge, figures.area) == pytest.approx((np.sqrt(2.0), 2.0))
    assert figures.volume == pytest.approx(2 * np.pi * 0.5 * 2.0)


def test_swapped_coordinates_are_called_that():
    """An axis on z = 0 means r and z are swapped: the message says so, not that elements are clockwise."""
    points, quads, boundaries = block()
    assert "swap the coordinates" in refusal(points[:, ::-1], quads, boundaries)

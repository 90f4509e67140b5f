"""Meshes that stand for bodies of revolution, and bars among them."""

from dataclasses import replace

import numpy as np
import pytest

from core_models.errors import MeshError
from meshes.axisymmetric import BAR, axisymmetric, check_bar
from meshes.block import block
from meshes.mesh import Mesh
from meshes.taylor_bar import taylor_bar


@pytest.fixture
def bar():
    """A bar of 3 x 3 elements of size 1 m."""
    return taylor_bar(3.0, 3.0, 3, 3)


def refusal(mesh):
    """The one line with which a mesh is refused as a bar."""
    with pytest.raises(MeshError) as caught:
        check_bar(axisymmetric(mesh))
    assert "\n" not in str(caught.value)
    return str(caught.value)


def named(mesh, **boundaries):
    """The mesh with some of its boundaries exchanged."""
    return replace(mesh, boundaries=mesh.boundaries | boundaries)


def test_nodes_of_the_axis_are_put_on_it_exactly(bar):
    """Round-off in r on the axis is removed, so that no radius is negative."""
    points = bar.points.copy()
    points[:, 0] += np.where(points[:, 0] == 0.0, [-1e-12, 1e-12] * 8, 0.0)
    mesh = axisymmetric(replace(bar, points=points))
    assert np.array_equal(mesh.points, bar.points)
    assert axisymmetric(bar) is bar


def test_body_on_the_wrong_side_of_the_axis_is_refused():
    """Radii are not negative; a body that does not touch the axis is allowed."""
    assert "move the body to r >= 0" in refusal(block([-0.5, 0], [1, 1], [3, 3]))
    assert axisymmetric(block([0.5, 0], [1, 1], [3, 3])).points[:, 0].min() == 0.5


def test_solid_bodies_are_refused():
    """A 3-D mesh has no (r, z) plane."""
    assert "is 3-D" in refusal(block([0, 0, 0], [1, 1, 1], [1, 1, 1], "hex8"))


def test_axis_that_is_not_on_the_axis_is_refused(bar):
    """The boundary named axis is exactly the edges on r = 0; swapped coordinates are called that."""
    swapped = Mesh(bar.points[:, ::-1], "quad4", bar.cells[:, ::-1], bar.boundaries)
    assert "swap the coordinates" in refusal(swapped)
    assert "is not in 'axis'" in refusal(named(bar, axis=bar.boundaries["axis"][:2]))
    assert "is in 'axis'" in refusal(replace(bar, points=bar.points + [1.0, 0.0]))


def test_bar_needs_its_four_names(bar):
    """A missing name comes with the nearest there is."""
    other = {name.replace("side", "sides"): nodes for name, nodes in bar.boundaries.items()}
    assert "'side' is missing; did you mean 'sides'" in refusal(replace(bar, boundaries=other))


def test_bars_boundaries_are_its_whole_rim(bar):
    """Every edge of the rim has one name; cracks and holes are found thereby."""
    side = bar.boundaries["side"]
    assert "from (3, 2) to (3, 3) m has no name" in refusal(named(bar, side=side[:2]))
    assert "is in both 'foot' and 'side'" in refusal(
        named(bar, side=np.vstack([side, bar.boundaries["foot"][:1]]))
    )
    points, cells = np.vstack([bar.points, bar.points[[1]]]), bar.cells.copy()
    cells[0, 1] = 16
    boundaries = bar.boundaries | {"foot": np.array([[0, 16], [1, 2], [2, 3]])}
    crack = refusal(Mesh(points, "quad4", cells, boundaries))
    assert "from (1, 0) to (1, 1) m has no name" in crack and "merge nodes that coincide" in crack
    assert "has no name" in refusal(replace(bar, cells=np.delete(bar.cells, 4, axis=0)))


def test_wrong_sequence_of_boundaries_is_refused(bar):
    """Rear and foot may not be exchanged round the body's loop."""
    side, rear = bar.boundaries["side"], bar.boundaries["rear"]
    assert "not foot, side, rear, axis one after the other" in refusal(named(bar, side=rear, rear=side))


def test_bars_boundaries_are_one_loop(bar):
    """The boundaries of a bar follow each other head to tail."""
    check_bar(bar)
    loop = np.concatenate([bar.boundaries[name] for name in BAR])
    assert (loop[:, 1] == np.roll(loop[:, 0], -1)).all()

"""Several bodies in one mesh."""

from dataclasses import replace

import numpy as np
import pytest

from core_models.errors import MeshError
from meshes.block import block
from meshes.disk import disk
from meshes.join import join
from meshes.kinds import KINDS
from meshes.taylor_quarter import taylor_quarter


def box(lower, upper, kind, counts=1):
    """A box of any dimension."""
    return block(lower, upper, [counts] * len(lower), kind)


def test_bodies_follow_each_other():
    """Nodes and cells of the bodies keep their order; boundaries of one name become one."""
    one, other = disk(1.0, 0.25), disk(1.0, 0.5, centre=(2.5, 0.0))
    both = join([one, other])
    assert np.array_equal(both.points, np.vstack([one.points, other.points]))
    assert np.array_equal(both.cells[len(one.cells) :], other.cells + len(one.points))
    assert len(both.boundaries["outer"]) == len(one.boundaries["outer"]) + len(other.boundaries["outer"])


@pytest.mark.parametrize("kind", KINDS)
def test_bodies_may_touch_but_not_overlap(kind):
    """Side by side is allowed, with other nodes on the other side of the seam too; a millionth of a size is not."""
    dimension = KINDS[kind].dimension
    one = box([0.0] * dimension, [1.0] * dimension, kind, 2)
    lower, upper = [1.0, *[0.1] * (dimension - 1)], [2.0, *[0.8] * (dimension - 1)]
    other = box(lower, upper, kind, 3)
    assert len(join([one, other]).cells) == len(one.cells) + len(other.cells)
    with pytest.raises(MeshError, match="bodies 0 and 1 of 2 overlap"):
        join([one, replace(other, points=other.points - np.eye(dimension)[0] * 1e-5)])


@pytest.mark.parametrize("kind", ["quad4", "tri3", "hex8", "tet4"])
def test_bodies_that_cross_without_a_node_inside_each_other_are_found(kind):
    """A cross of two bars overlaps in its middle, although no node of one lies in the other."""
    rest = [0.1] * (KINDS[kind].dimension - 1)
    along = box([-1.0, *(-x for x in rest)], [1.0, *rest], kind)
    across = box([-0.1, -1.0, *(-x for x in rest[1:])], [0.1, 1.0, *rest[1:]], kind)
    with pytest.raises(MeshError, match=r"their boxes share 0.2 x 0.2.*near \(0, 0"):
        join([along, across])


def test_body_within_another_is_found():
    """A small body inside an element of a large one overlaps it."""
    with pytest.raises(MeshError, match=r"elements 0 and 1 lie in the same place near \(0.35, 0.35\) m"):
        join([box([0, 0], [1, 1], "quad4"), box([0.3, 0.3], [0.4, 0.4], "quad4")])


def test_disks_whose_boxes_overlap_are_apart():
    """Disks on a diagonal may lie nearer than their boxes, up to their touch."""
    assert len(join([disk(1.0, 0.1), disk(1.0, 0.1, centre=(1.5, 1.5))]).cells) == 600
    with pytest.raises(MeshError, match="their boxes share 0.6 x 0.6 m"):
        join([disk(1.0, 0.1), disk(1.0, 0.1, centre=(1.4, 1.4))])


def test_curved_bodies_may_stand_on_each_other():
    """Two quarter bars, one on the other, share a plane of equal facets."""
    lower = taylor_quarter(1.0, 2.0, 4)
    upper = taylor_quarter(1.0, 2.0, 4, foot_height=2.0)
    assert len(join([lower, upper]).cells) == 2 * len(lower.cells)


def test_more_than_two_bodies_are_checked_pair_by_pair():
    """Of many bodies the two that overlap are named."""
    boxes = [box([3.0 * i, 0.0], [3.0 * i + 1.0, 1.0], "quad4") for i in range(6)]
    join(boxes)
    with pytest.raises(MeshError, match="bodies 4 and 6 of 7 overlap"):
        join([*boxes, box([12.5, 0.5], [14.0, 2.0], "quad4")])


def test_bodies_of_different_kinds_are_refused():
    """One mesh has one kind of element, and at least one body."""
    with pytest.raises(MeshError, match="consist of quad4, tri3 elements; mesh them all with one kind"):
        join([box([0, 0], [1, 1], "quad4"), box([2, 0], [3, 1], "tri3")])
    with pytest.raises(MeshError, match="no mesh is given"):
        join([])

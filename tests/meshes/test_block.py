"""Blocks of all kinds of element."""

import numpy as np
import pytest

from core_models.errors import MeshError
from meshes.block import block
from meshes.facets import find_facets
from meshes.kinds import KINDS


def sides(mesh):
    """The number of facets of each boundary."""
    return {name: len(nodes) for name, nodes in mesh.boundaries.items()}


@pytest.mark.parametrize("kind", KINDS)
def test_boundaries_are_the_whole_rim(kind):
    """Left, right, bottom, top (front, back) hold every facet of the rim once, where they should be."""
    dimension = KINDS[kind].dimension
    low, high = [-1.0, 0.5, 2.0][:dimension], [1.0, 3.0, 2.5][:dimension]
    mesh = block(low, high, [3, 2, 4][:dimension], kind)
    facets = find_facets(kind, mesh.points, mesh.cells)
    assert sum(sides(mesh).values()) == len(facets.rim())
    assert (mesh.points[mesh.boundaries["left"], 0] == -1.0).all()
    assert (mesh.points[mesh.boundaries["top"], -1] == high[-1]).all()


@pytest.mark.parametrize("kind", KINDS)
def test_distortion_moves_the_nodes_inside_only(kind):
    """Nodes inside move, by at most their part of the distance of nodes; the same seed moves them the same way."""
    dimension = KINDS[kind].dimension
    box = ([0.0] * dimension, [1.0] * dimension, [3] * dimension, kind)
    even, moved = block(*box), block(*box, distortion=0.1, seed=4)
    shift = np.abs(moved.points - even.points)
    inside = ((even.points > 0.0) & (even.points < 1.0)).all(axis=1)
    assert shift[~inside].max() < 1e-15
    assert (shift[inside].max(axis=1) > 0.0).all()
    assert shift.max() <= 0.1 / 3 / KINDS[kind].degree
    assert moved.points.tobytes() == block(*box, distortion=0.1, seed=4).points.tobytes()
    assert moved.points.tobytes() != block(*box, distortion=0.1, seed=5).points.tobytes()


@pytest.mark.parametrize(
    ("wrong", "told"),
    [
        ({"lower": [0, 0, 0]}, "give 2 numbers for quad4"),
        ({"upper": [1, 0]}, "lower < upper"),
        ({"upper": [1, np.inf]}, "finite"),
        ({"counts": [2, 0]}, "at least 1"),
        ({"counts": [2.5, 1]}, "whole numbers"),
        ({"kind": "quad5"}, "did you mean 'quad"),
        ({"distortion": 0.5}, "distortion is 0.5"),
        ({"distortion": np.nan}, "distortion is nan"),
    ],
)
def test_senseless_parameters_are_refused_by_name(wrong, told):
    """A parameter outside its range is a one-line MeshError with its value."""
    with pytest.raises(MeshError, match=told) as caught:
        block(**{"lower": [0, 0], "upper": [1, 1], "counts": [2, 2]} | wrong)
    assert "\n" not in str(caught.value)

"""Quadratic B-splines on the grid: partition of unity and linear fields, everywhere in the body."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from mpm.grid import GHOSTS, slopes, stencil, weights

CELL = 0.4e-3
ROUND_OFF = 1e-14
anywhere = st.floats(0.0, 50.0 * CELL)


def nodes_along(coordinate, offset, lowest):
    """Coordinates of the three nodes that a point reaches, their weights and slopes."""
    first, distance = stencil(coordinate, 1.0 / CELL, offset)
    places = (first + np.arange(3) - lowest + 0.5) * CELL
    return places, np.array(weights(distance)), np.array(slopes(distance, 1.0 / CELL))


@given(anywhere)
def test_weights_are_a_partition_of_unity(coordinate):
    """Weights are positive and sum to 1, slopes sum to 0, from the axis and the wall on."""
    for offset, lowest in ((0, 1), (GHOSTS - 1, GHOSTS)):
        _, weight, slope = nodes_along(coordinate, offset, lowest)
        assert (weight >= 0.0).all()
        assert weight.sum() == pytest.approx(1.0, abs=ROUND_OFF)
        assert abs(slope.sum()) * CELL < ROUND_OFF


@given(anywhere)
def test_weights_reproduce_linear_fields(coordinate):
    """Interpolated node coordinates are the coordinate itself, and their slope is 1."""
    for offset, lowest in ((0, 1), (GHOSTS - 1, GHOSTS)):
        places, weight, slope = nodes_along(coordinate, offset, lowest)
        assert weight @ places == pytest.approx(coordinate, abs=100.0 * ROUND_OFF * CELL)
        assert slope @ (places - places[1]) == pytest.approx(1.0, abs=ROUND_OFF)


@given(anywhere)
def test_second_moment_of_the_weights_is_a_quarter_of_a_cell_squared(coordinate):
    """Sum N (x_i - x)^2 = h^2 / 4 everywhere, which the affine transfer relies on."""
    places, weight, _ = nodes_along(coordinate, 0, 1)
    assert weight @ (places - coordinate) ** 2 == pytest.approx(0.25 * CELL**2, rel=1e-11)


@given(st.floats(0.01, 40.0), st.floats(-1e-6, 1e-6))
def test_slopes_are_the_derivative_of_the_weights(cells, step):
    """A small move changes the weights by slope times move, also across the edge of a cell."""
    change = np.zeros(60)
    for position, sign in ((cells * CELL, -1.0), ((cells + step) * CELL, 1.0)):
        first, distance = stencil(position, 1.0 / CELL, 0)
        change[first : first + 3] += sign * np.array(weights(distance))
    first, distance = stencil(cells * CELL, 1.0 / CELL, 0)
    change[first : first + 3] -= np.array(slopes(distance, 1.0 / CELL)) * step * CELL
    assert np.abs(change).max() < 2.0 * step**2 + ROUND_OFF

"""The interpolations: partition of unity, linear fields and moments, everywhere in the body."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from core_models.compilation import kernel
from core_models.geometry import Spatial
from mpm.geometries import stand
from mpm.grid import find_box, make_grid
from mpm.interpolation import half_size, reach, spread
from mpm.interpolation.cubic import CubicSpline
from mpm.interpolation.gimp import UniformGimp
from mpm.interpolation.linear import LinearHat
from mpm.interpolation.quadratic import QuadraticSpline
from mpm.lanes import store
from mpm.tile import MOMENTS, OFFSETS, SLOPES, STENCIL, WEIGHTS, put_moments, put_offsets, put_stencil

CELL = 0.4e-3
SPLINES = [LinearHat(), QuadraticSpline(), CubicSpline()]
SHAPES = [*SPLINES, UniformGimp(CELL * np.array([[0.25, 0.1, 0.5]]))]
IDS = ["linear", "quadratic", "cubic", "gimp"]
BASE = np.array([0.1, -0.2, 0.0]) * CELL
GRID = make_grid(CELL, BASE, find_box(CELL, BASE, np.zeros((1, 3))), 1)
place = st.floats(-20.0, 20.0)
places = st.tuples(place, place, place)
ROUND_OFF = 1e-14


@kernel
def fill(table, moments, geometry, shape, grid, positions):
    """Fill the tables of particle 0 and its second moments; returns its first nodes."""
    i, j, k, t = stand(geometry, shape, grid, positions, 0)
    put_stencil(table, geometry, shape, 0, t, grid.over_h)
    put_moments(moments, table, geometry, shape, 0, t, grid.over_h)
    put_offsets(table, shape, t, grid.h)
    store(moments, 0, spread(shape, t, half_size(shape, 0, grid.over_h)))
    return i, j, k


def stencil(shape, cells):
    """First nodes, and by axis the weights, slopes [1/m], moments [1/m], offsets [m] and second moments [cells^2]."""
    table, moments, position = np.full(STENCIL, np.nan), np.zeros(4), CELL * np.array([cells])
    first = fill(table, moments, Spatial(), shape, GRID, position)
    rows = [
        table[start : start + 4 * reach(shape)].reshape(-1, 4)[:, :3].T
        for start in (WEIGHTS, SLOPES, MOMENTS, OFFSETS)
    ]
    return np.array(first), position[0], rows, moments[:3]


@pytest.fixture(scope="module", autouse=True)
def compiled():
    """Compile first, lest the first example of each test takes too long."""
    for shape in SHAPES:
        stencil(shape, (0.0, 0.0, 0.0))


@pytest.mark.parametrize("shape", SHAPES, ids=IDS)
@given(places)
def test_weights_are_a_partition_of_unity(shape, cells):
    """Weights are not negative and sum to 1, slopes sum to 0."""
    _, _, (weight, slope, _, _), _ = stencil(shape, cells)
    assert (weight >= -ROUND_OFF).all()
    assert np.abs(weight.sum(axis=1) - 1.0).max() < 10.0 * ROUND_OFF
    assert np.abs(slope.sum(axis=1)).max() * CELL < 10.0 * ROUND_OFF


@pytest.mark.parametrize("shape", SHAPES, ids=IDS)
@given(places)
def test_linear_fields_and_their_gradients_are_reproduced(shape, cells):
    """Interpolated node coordinates are the coordinate itself, their slope and affine velocity are 1."""
    first, position, (weight, slope, moment, offset), _ = stencil(shape, cells)
    places_ = GRID.base[:, None] + CELL * (first[:, None] + np.arange(reach(shape)) + 0.5)
    assert np.abs((weight * places_).sum(axis=1) - position).max() < 20.0 * 20.0 * ROUND_OFF * CELL
    assert np.abs(places_ - position[:, None] - offset).max() < 1e-12 * CELL
    assert np.abs((slope * offset).sum(axis=1) - 1.0).max() < 100.0 * ROUND_OFF
    assert np.abs((moment * offset).sum(axis=1) - 1.0).max() < 100.0 * ROUND_OFF
    assert np.abs(moment.sum(axis=1)).max() * CELL < 100.0 * ROUND_OFF


@pytest.mark.parametrize("shape", SHAPES, ids=IDS)
@given(places)
def test_moments_are_those_of_the_affine_transfer(shape, cells):
    """Moment = weight times distance over D, with D = sum of weight times squared distance, wherever D is not 0."""
    _, _, (weight, _, moment, offset), second = stencil(shape, cells)
    assert np.abs((weight * offset**2).sum(axis=1) - second * CELL**2).max() < 100.0 * ROUND_OFF * CELL**2
    assert np.abs(moment * second[:, None] * CELL**2 - weight * offset).max() < 100.0 * ROUND_OFF * CELL


@pytest.mark.parametrize("shape", SHAPES, ids=IDS)
@given(place, st.floats(-1e-6, 1e-6))
def test_slopes_are_the_derivative_of_the_weights(shape, x, step):
    """A small move changes the weights by slope times move, also across the edge of a cell, tents' tips apart."""
    if isinstance(shape, LinearHat) and abs((x - 0.6 + 0.5) % 1.0 - 0.5) < 2e-6:
        return
    change = np.zeros(60)
    for at, sign in ((x, -1.0), (x + step, 1.0)):
        first, _, (weight, _, _, _), _ = stencil(shape, (at, 0.0, 0.0))
        node = int(first[0]) + 30
        change[node : node + reach(shape)] += sign * weight[0]
    first, _, (_, slope, _, _), _ = stencil(shape, (x, 0.0, 0.0))
    node = int(first[0]) + 30
    change[node : node + reach(shape)] -= slope[0] * step * CELL
    assert np.abs(change).max() < 10.0 * step**2 + 100.0 * ROUND_OFF

"""The incremental update of rotation and left stretch."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.linalg import polar
from scipy.spatial.transform import Rotation

from core_models.paths import rotations
from core_models.rotation import rotation_increment
from core_models.tensors import IDENTITY

SEED = st.integers(0, 2**32 - 1)


def assert_polar(f, before):
    """The new rotation and stretch are those of the polar decomposition f = V R."""
    increment, stretch = rotation_increment(tuple(f.ravel()), tuple(before.ravel()))
    rotation = np.reshape(increment, (3, 3)) @ before
    left = np.array(stretch)[[[0, 3, 5], [3, 1, 4], [5, 4, 2]]]
    expected, expected_left = polar(f, side="left")
    assert rotation == pytest.approx(expected, abs=5e-11)
    assert left == pytest.approx(expected_left, abs=5e-11 * np.abs(f).max())


@settings(max_examples=300, deadline=None)
@given(seed=SEED, step=st.sampled_from([(np.pi, 0.5), (0.12, 3.0)]))
def test_any_step_ends_at_the_polar_decomposition(seed, step):
    """R and V belong to F: for any rotation in a step at moderate strain, for up to 7 degrees at any strain."""
    angle, strain = step
    random = np.random.default_rng(seed)
    before = Rotation.random(rng=random).as_matrix()
    turn = rotations(random.normal(size=3), [random.uniform(0.0, angle)])[0]
    axes = Rotation.random(rng=random).as_matrix()
    stretch = axes @ np.diag(np.exp(random.uniform(-strain, strain, 3))) @ axes.T
    assert_polar(stretch @ turn @ before, before)


@settings(max_examples=100, deadline=None)
@given(seed=SEED, angle=st.floats(-np.pi, np.pi), strain=st.floats(0.0, 1.5))
def test_any_planar_step_ends_at_the_polar_decomposition(seed, angle, strain):
    """Also in plane and axisymmetric motion, which has a closed form of its own."""
    random = np.random.default_rng(seed)
    before = rotations([0.0, 0.0, 1.0], [random.uniform(-np.pi, np.pi)])[0]
    axes = rotations([0.0, 0.0, 1.0], [random.uniform(-np.pi, np.pi)])[0]
    stretch = axes @ np.diag(np.exp(random.uniform(-strain, strain, 3))) @ axes.T
    assert_polar(stretch @ rotations([0.0, 0.0, 1.0], [angle])[0] @ before, before)


@pytest.mark.parametrize("axis", [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, -2.0, 0.5]])
@pytest.mark.parametrize("degrees", [75.0, 90.0, 120.0, 179.0, 180.0])
def test_half_a_turn_in_one_step(axis, degrees):
    """Rotations up to half a turn about any axis are found in one step."""
    turn = rotations(axis, [np.radians(degrees)])[0]
    assert_polar(turn @ np.diag([1.3, 0.9, 0.8]), np.eye(3))
    assert_polar(turn, np.eye(3))


def test_no_motion_is_no_rotation():
    """An undeformed point at rest keeps exactly the identity."""
    increment, stretch = rotation_increment(IDENTITY, IDENTITY)
    assert increment == IDENTITY
    assert stretch == (1.0, 1.0, 1.0, 0.0, 0.0, 0.0)


def test_rotation_and_stretch_do_not_drift():
    """After 3,000 steps along a wild path R is orthogonal and V R is F, to round-off."""
    random = np.random.default_rng(7)
    f, rotation = np.eye(3), IDENTITY
    for _ in range(3000):
        f = (np.eye(3) + random.uniform(-0.1, 0.1, (3, 3))) @ f
        f /= np.cbrt(np.linalg.det(f))
        if np.linalg.cond(f) > 30.0:
            f = rotations(random.normal(size=3), [0.3])[0] @ np.reshape(rotation, (3, 3))
        increment, stretch = rotation_increment(tuple(f.ravel()), rotation)
        rotation = tuple((np.reshape(increment, (3, 3)) @ np.reshape(rotation, (3, 3))).ravel())
    r = np.reshape(rotation, (3, 3))
    left = np.array(stretch)[[[0, 3, 5], [3, 1, 4], [5, 4, 2]]]
    assert r @ r.T == pytest.approx(np.eye(3), abs=1e-11)
    assert left @ r == pytest.approx(f, abs=1e-11)

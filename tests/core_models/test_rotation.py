"""The incremental update of rotation and left stretch."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.linalg import polar
from scipy.spatial.transform import Rotation

from core_models.paths import rotations
from core_models.quaternions import (
    quaternion,
    quaternion_of_matrix,
    rotation_matrix,
    rotation_vector,
    turned,
)
from core_models.rotation import rotation_increment, small_rotation_increment
from core_models.tensors import IDENTITY

SEED = st.integers(0, 2**32 - 1)


FULL = [[0, 3, 5], [3, 1, 4], [5, 4, 2]]


def matrix(q):
    """Rotation of a quaternion as (3, 3)."""
    return np.reshape(rotation_matrix(q), (3, 3))


def assert_polar(f, before):
    """The new rotation and stretch are those of the polar decomposition f = V R."""
    increment, stretch = rotation_increment(tuple((f @ before.T).ravel()))
    q = matrix(increment)
    expected, expected_left = polar(f, side="left")
    assert q @ before == pytest.approx(expected, abs=5e-11)
    left = q @ np.array(stretch)[FULL] @ q.T
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
    increment, stretch = rotation_increment(IDENTITY)
    assert rotation_matrix(increment) == IDENTITY
    assert stretch == (1.0, 1.0, 1.0, 0.0, 0.0, 0.0)


@settings(max_examples=200, deadline=None)
@given(seed=SEED, degrees=st.sampled_from([0.0, 1e-9, 1e-4, 0.01, 0.1, 0.3]))
def test_the_straight_line_is_right_for_the_rotation_of_a_step(seed, degrees):
    """Up to a third of a degree at any strain it says so and gives the polar decomposition to round-off."""
    random = np.random.default_rng(seed)
    turn = rotations(random.normal(size=3), [np.radians(degrees)])[0]
    axes = Rotation.random(rng=random).as_matrix()
    stretch = axes @ np.diag(np.exp(random.uniform(-1.0, 1.0, 3))) @ axes.T
    increment, found, is_right = small_rotation_increment(tuple((turn @ stretch).ravel()))
    assert is_right
    assert matrix(increment) == pytest.approx(turn, abs=1e-14)
    assert np.array(found)[FULL] == pytest.approx(stretch, abs=1e-13)


@settings(max_examples=200, deadline=None)
@given(seed=SEED, angle=st.floats(0.01, np.pi), strain=st.floats(0.0, 3.0))
def test_the_straight_line_is_never_wrong_unawares(seed, angle, strain):
    """For large rotations and strains it gives the polar decomposition or says that it does not."""
    random = np.random.default_rng(seed)
    turn = rotations(random.normal(size=3), [angle])[0]
    axes = Rotation.random(rng=random).as_matrix()
    stretch = axes @ np.diag(np.exp(random.uniform(-strain, strain, 3))) @ axes.T
    increment, _found, is_right = small_rotation_increment(tuple((turn @ stretch).ravel()))
    assert not is_right or matrix(increment) == pytest.approx(turn, abs=1e-9)


def test_rotation_does_not_drift():
    """After 3,000 steps along a wild path the stored vector is no longer than 1 and gives V R = F, to round-off."""
    random = np.random.default_rng(7)
    f, vector = np.eye(3), (0.0, 0.0, 0.0)
    for _ in range(3000):
        f = (np.eye(3) + random.uniform(-0.1, 0.1, (3, 3))) @ f
        f /= np.cbrt(np.linalg.det(f))
        before = quaternion(vector)
        if np.linalg.cond(f) > 30.0:
            f = rotations(random.normal(size=3), [0.3])[0] @ matrix(before)
        increment, _stretch = rotation_increment(tuple((f @ matrix(before).T).ravel()))
        vector = rotation_vector(turned(increment, before))
        assert np.linalg.norm(vector) <= 1.0 + 1e-15
    assert matrix(quaternion(vector)) == pytest.approx(polar(f)[0], abs=1e-11)


@settings(max_examples=200, deadline=None)
@given(seed=SEED, angle=st.sampled_from([0.0, 1e-9, 1.0, 3.0, np.pi - 1e-9, np.pi]))
def test_three_numbers_hold_any_rotation(seed, angle):
    """Rotations about any axis up to half a turn go to three numbers and come back, to round-off."""
    random = np.random.default_rng(seed)
    turn = rotations(random.normal(size=3), [angle])[0]
    q = quaternion_of_matrix(tuple(turn.ravel()))
    assert matrix(q) == pytest.approx(turn, abs=1e-15)
    assert matrix(quaternion(rotation_vector(q))) == pytest.approx(turn, abs=2e-15)
    assert (
        np.array(rotation_vector(q))
        == pytest.approx(
            np.tan(angle / 4.0) * Rotation.from_matrix(turn).as_rotvec() / (angle or 1.0), abs=1e-7
        )
        or angle > 3.1
    )

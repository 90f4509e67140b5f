"""Measures of polylines against exact shapes."""

import numpy as np
import pytest

from core_models.errors import SceneError
from studies.bar import profile


def cylinder(radius=2.0, height=5.0):
    """Half section of a cylinder, counter-clockwise from the axis."""
    return {
        "foot": np.array([[0.0, 0.0], [radius, 0.0]]),
        "side": np.array([[radius, 0.0], [radius, height]]),
        "rear": np.array([[radius, height], [0.0, height]]),
    }


def sphere_cap(radius=1.0, count=4000):
    """Half section of a half ball on its flat face."""
    angle = np.linspace(0.0, np.pi / 2, count)
    return np.concatenate([[[0.0, 0.0]], np.column_stack([radius * np.cos(angle), radius * np.sin(angle)])])


def test_cylinder_is_measured_exactly():
    """Area, volume and centroid of a cylinder are exact."""
    polygon = profile.half_profile(cylinder())
    assert profile.area(polygon) == pytest.approx(10.0, rel=1e-14)
    assert profile.revolved_volume(polygon) == pytest.approx(np.pi * 4.0 * 5.0, rel=1e-14)
    assert profile.centroid(polygon) == pytest.approx([1.0, 2.5], rel=1e-14)


def test_cone_is_measured_exactly():
    """Volume pi R^2 H / 3, area R H / 2, slant height, radius and height along it."""
    cone = np.array([[0.0, 0.0], [3.0, 0.0], [0.0, 6.0]])
    assert profile.revolved_volume(cone) == pytest.approx(np.pi * 9.0 * 6.0 / 3.0, rel=1e-14)
    assert profile.area(cone) == pytest.approx(9.0, rel=1e-14)
    assert profile.arc_length(cone[1:]) == pytest.approx(np.hypot(3.0, 6.0), rel=1e-14)
    assert profile.radius_at_height(cone[1:], 2.0) == pytest.approx(2.0, rel=1e-14)
    assert profile.first_exceeding(cone[:0:-1], 1.0) == pytest.approx(4.0, rel=1e-14)


def test_half_ball_is_approached():
    """Volume 2/3 pi, quarter circle of length pi/2, centroid 4/(3 pi) of the quarter disc."""
    ball = sphere_cap()
    assert profile.revolved_volume(ball) == pytest.approx(2.0 / 3.0 * np.pi, rel=1e-6)
    assert profile.arc_length(ball[1:]) == pytest.approx(np.pi / 2, rel=1e-6)
    assert profile.centroid(ball) == pytest.approx([4.0 / (3.0 * np.pi)] * 2, rel=1e-6)


def test_mean_height_weights_by_area():
    """A conical face z = r on radius R has the area-weighted mean height 2 R / 3, walked either way."""
    face = np.array([[3.0, 3.0], [1.0, 1.0], [0.0, 0.0]])
    assert profile.mean_height(face) == pytest.approx(2.0, rel=1e-14)
    assert profile.mean_height(face[::-1]) == pytest.approx(2.0, rel=1e-14)


def test_median_height_ignores_one_noisy_corner():
    """A flat face with one corner out of place has the height of the flat part; what is outside does not count."""
    face = np.array([[0.0, 1.0], [0.5, 0.2], [1.0, 1.0], [2.0, 1.0], [3.0, 1.0], [9.0, 5.0]])
    assert profile.median_height(face, 3.0) == pytest.approx(1.0)


def test_largest_radius_is_taken_where_a_line_folds():
    """A side that overhangs crosses a height more than once: the outermost crossing counts."""
    line = np.array([[2.0, 0.0], [3.0, 1.0], [2.5, 0.4], [1.0, 3.0]])
    assert profile.radius_at_height(line, 0.5) == pytest.approx(2.5 + 0.5 / 6.0)


def test_height_beyond_the_profile_is_refused():
    """Asking for a radius above the bar is an error that says so."""
    with pytest.raises(SceneError, match="does not reach"):
        profile.radius_at_height(cylinder()["side"], 6.0)


def test_radius_never_exceeded_is_none():
    """An undeformed side exceeds nothing."""
    assert profile.first_exceeding(cylinder()["side"], 2.02) is None


def test_distance_between_parallel_lines_is_their_gap():
    """Two shifted lines of one length lie their shift apart, and a line lies on itself."""
    side = cylinder()["side"]
    assert profile.distance_between(side, side) == pytest.approx(0.0, abs=1e-14)
    assert profile.distance_between(side, side + [0.25, 0.0]) == pytest.approx(0.25, rel=1e-12)

"""The speed table's measurement."""

import numpy as np
import pytest

from core_models import points as points_module
from core_models.kernels import advance_points
from core_models.points import MaterialPoints
from studies.bench import yardstick
from studies.bench.materials import bench_materials, yardstick_material
from studies.bench.speeds import _point_update


def test_law_combinations_have_names_of_their_own():
    """Every combination is measured under one name, the founding one among them."""
    names = [name for name, _ in bench_materials()]
    assert len(names) == len(set(names)) >= 8
    assert "hypoelastic, Johnson-Cook, Mie-Grüneisen" in names


def test_point_updates_are_timed():
    """Every repeat takes some time; the points are plastic."""
    _, material = next(bench_materials())
    assert all(seconds > 0.0 for seconds in _point_update(material, 300, 1))


def test_the_yardstick_does_what_the_machinery_of_laws_does(monkeypatch):
    """The hand-written update and that of the laws agree to round-off: elastic, plastic, large and melted steps."""
    monkeypatch.setattr(points_module, "advance_points", getattr(advance_points, "py_func", advance_points))
    by_hand = yardstick.advance_by_hand
    monkeypatch.setattr(yardstick, "advance_by_hand", getattr(by_hand, "py_func", by_hand))
    points = MaterialPoints(yardstick_material(), np.full(40, 1e-9))
    gradient = np.random.default_rng(1).uniform(-1.0, 1.0, (points.n, 3, 3))
    points.old.temperature[:3] = 1400.0
    for size in (1e-5, 1e-3, 2e-2, 0.2):
        increment = np.eye(3) + size * gradient
        points.deformation_gradient[:] = increment @ points.old_deformation_gradient
        points.advance(1e-6)
        expected = {name: array.copy() for name, array in points.new._asdict().items() if array is not None}
        speed = points.wave_speed.copy()
        yardstick.by_hand(points, 1e-6)()
        for name, array in expected.items():
            assert getattr(points.new, name) == pytest.approx(
                array, rel=1e-9, abs=1e-9 * np.abs(array).max()
            ), name
        assert points.wave_speed == pytest.approx(speed, rel=1e-12)
        points.accept()

"""The speed table's measurement."""

from studies.bench import _point_update
from studies.bench_materials import bench_materials


def test_law_combinations_have_names_of_their_own():
    """Every combination is measured under one name, the founding one among them."""
    names = [name for name, _ in bench_materials()]
    assert len(names) == len(set(names)) >= 8
    assert "hypoelastic, Johnson-Cook, Mie-Grüneisen" in names


def test_point_updates_are_timed():
    """Every repeat takes some time; the points are plastic."""
    _, material = next(bench_materials())
    assert all(seconds > 0.0 for seconds in _point_update(material, 300, 1))

"""The measured quantities of a bar, on the outlines of known bodies."""

import numpy as np
import pytest

from studies.bar.quantity_names import QUANTITIES
from studies.bar.shape import foot_height, foot_radius, length, rim_lift, standing
from studies.runs.running import run

MUSHROOM = {
    "foot": np.array([[0.0, 0.1], [3.0, 0.1], [7.0, 0.3]]),
    "side": np.array([[7.0, 0.3], [4.0, 3.1], [3.0, 8.1], [3.0, 20.1]]),
    "rear": np.array([[3.0, 20.1], [0.0, 20.1]]),
}


def test_a_lifted_bar_is_measured_from_its_own_foot():
    """Length, rim lift and foot radius do not depend on the flight height."""
    assert length(MUSHROOM) == pytest.approx(20.0)
    assert rim_lift(MUSHROOM) == pytest.approx(0.2)
    assert foot_radius(MUSHROOM) == pytest.approx(7.0)


def test_a_wide_rear_is_not_the_foot():
    """The foot radius is looked for in the lower half only."""
    tail = MUSHROOM | {"side": np.vstack([MUSHROOM["side"], [[9.0, 20.1]]])}
    assert foot_radius(tail) == pytest.approx(7.0)


def test_a_standing_outline_touches_the_wall():
    """Moving an outline to z = 0 keeps its shape."""
    moved = standing(MUSHROOM)
    assert foot_height(moved) == 0.0
    assert length(moved) == pytest.approx(20.0)


def test_every_quantity_is_reported_with_its_unit(fake_solvers, classic):
    """A run reports exactly the named quantities, in order; missing ones say why."""
    result = run(classic, "mpm", 10, wall="plane")
    assert tuple(result.quantities) == QUANTITIES
    assert all(quantity.unit for quantity in result.quantities.values())
    missing = {name: q.note for name, q in result.quantities.items() if q.value is None}
    assert missing == {
        "max_temperature": "the material has no temperature",
        "contact_duration": "a plane wall never lets go",
    }


def test_a_uniformly_shortened_cylinder_is_measured_exactly(fake_solvers, classic):
    """All shape quantities of a straight cylinder follow from its length and radius."""
    quantities = run(classic, "mpm", 10, wall="plane").quantities
    length, radius = 32.4e-3 * (1.0 - 0.33), 3.2e-3 / np.sqrt(1.0 - 0.33)
    expected = {
        "final_length": length,
        "foot_radius": radius,
        "rim_lift": 0.0,
        "radius_at_0.2_L0": radius,
        "undeformed_length": 0.0,
        "profile_arc_length": length,
        "profile_area": length * radius,
        "volume": np.pi * radius**2 * length,
        "centroid_r": radius / 2,
        "centroid_z": length / 2,
        "max_equivalent_plastic_strain": 0.44,
    }
    for name, value in expected.items():
        assert quantities[name].value == pytest.approx(value, rel=1e-9, abs=1e-15), name


def test_contact_lasts_from_first_to_last_touch(fake_solvers, classic):
    """Under the unilateral wall the contact duration is that of the impact, to a step."""
    duration = run(classic, "mpm", 10, wall="unilateral").quantities["contact_duration"]
    assert duration.value == pytest.approx(60e-6, abs=1.01e-6)

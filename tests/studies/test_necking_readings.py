"""What is read off a necking run: closed forms, quantities of made curves, checks of runs."""

import numpy as np
import pytest

from studies.necking.bar_necking import (
    NeckingHistory,
    at_elongation,
    bridgman_factor,
    fall_to,
    first_failure,
    is_broken,
    neck_curvature,
    peak,
    uniform_peak,
)
from studies.necking.run import NeckingRun
from studies.necking.verdicts import criteria_of
from studies.scenes.material_finder import with_update
from tests.studies.necking_samples import SIMO, history


def test_closed_forms_of_the_largest_uniform_force():
    """79.46 kN where the flow stress is the Kirchhoff stress, 79.58 kN where it is the Cauchy stress."""
    assert uniform_peak(SIMO.material, SIMO.radius) == pytest.approx(79.46e3, rel=1e-4)
    assert uniform_peak(with_update(SIMO.material, "hypoelastic"), SIMO.radius) == pytest.approx(
        79.58e3, rel=1e-4
    )


def test_peak_of_a_parabola_is_exact_between_its_points():
    """The largest force of a curve is found between increments."""
    u = np.linspace(0.0, 1.0, 8)
    assert peak(history(u, 5.0 - (u - 0.47) ** 2)) == pytest.approx((0.47, 5.0), rel=1e-12)


def test_values_beyond_the_end_of_a_run_are_not_made_up():
    """At an elongation that a run has not reached there is no value."""
    made = history([0.0, 1.0], [0.0, 2.0])
    assert at_elongation(made, "force", 0.25) == 0.5 and at_elongation(made, "force", 1.1) is None


def test_bridgman_factor_agrees_with_his_table():
    """a / R = 0.1, 0.25, 0.5, 1: 0.976, 0.943, 0.896, 0.822; 1 without a neck."""
    factors = [bridgman_factor(1.0, curvature) for curvature in (0.1, 0.25, 0.5, 1.0)]
    assert factors == pytest.approx([0.976, 0.943, 0.896, 0.822], abs=6e-4)
    assert bridgman_factor(1.0, 0.0) == 1.0


def test_curvature_of_a_round_notch_is_found():
    """A circle of radius 2 that touches r = 1 at z = 0."""
    z = np.linspace(0.0, 1.0, 41)
    side = np.column_stack([3.0 - np.sqrt(4.0 - z**2), z])
    assert neck_curvature(side) == pytest.approx(0.5, rel=0.02)


def test_fracture_and_first_failure_are_read_from_the_curve():
    """Broken where a tenth of the largest force is left; failed where the first point has; nothing made up without."""
    made = history(
        [0.0, 1.0, 2.0, 3.0],
        [0.0, 10.0, 6.0, 0.0],
        failed=[0.0, 0.0, 0.1, 0.2],
        failed_place=[0.0, 0.0, 0.25, 0.25],
    )
    assert fall_to(made, 0.1) == pytest.approx(2.0 + 5.0 / 6.0)
    assert first_failure(made) == (2.0, 0.25)
    whole = history([0.0, 1.0], [0.0, 2.0])
    assert fall_to(whole, 0.1) is None and first_failure(whole) == (None, None)


def test_a_run_ends_when_the_body_is_broken():
    """With less than a hundredth of the largest force; a start from nothing and a bar that holds are not broken."""
    assert not is_broken(NeckingHistory()) and not is_broken(history([0.0, 1.0], [0.0, 2.0]))
    assert not is_broken(history([0.0, 1.0, 2.0], [1.0, 10.0, 0.2]))
    assert is_broken(history([0.0, 1.0, 2.0], [1.0, 10.0, 0.05]))


def test_checks_are_of_runs_that_were_made():
    """A run that is twice another breaks their agreement; checks of runs that are missing say nothing."""
    u = np.linspace(0.0, 7e-3, 30)
    force, radius = 77.3e3 - 3e9 * (u - 2.83e-3) ** 2, np.linspace(6.3e-3, 2e-3, 30)
    made = [
        NeckingRun(history(u, factor * force, neck_radius=radius), np.zeros((1, 4, 2)), np.zeros(1), 1.0, 30)
        for factor in (1.0, 2.0)
    ]
    runs = dict(zip(("fem-implicit", "fem-explicit"), made, strict=True))
    found = {each.what: each for each in criteria_of(SIMO, runs)}
    agreements = [each for what, each in found.items() if "against fem-implicit" in what]
    assert [each.met for each in agreements] == [False, True, True]
    assert agreements[0].value == pytest.approx(100.0)
    assert not any("mpm" in what for what in found)

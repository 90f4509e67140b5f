"""Coarse bars that neck: as a body of revolution, as an eighth in three dimensions, and a square one."""

import math
from dataclasses import replace

import numpy as np
import pytest

from studies.necking.bar_necking import at_elongation, peak, uniform_peak
from studies.necking.methods import make_run
from studies.necking.scene import PlannedRun
from tests.studies.necking_samples import SIMO


def test_coarse_bar_necks_near_the_other_codes():
    """4 x 12 elements in 50 increments: peak 77.3 kN within 0.3 %, no cut; Bridgman within 5 and 10 %."""
    run = make_run(SIMO, PlannedRun("coarse", "fem-implicit", 4, 12, 0.25, increments=50))
    at, force = peak(run.history)
    assert force == pytest.approx(77.3e3, rel=3e-3) and at == pytest.approx(2.83e-3, abs=0.05e-3)
    assert at_elongation(run.history, "force", 4e-3) == pytest.approx(71.2e3, rel=0.015)
    assert run.cuts == 0 and run.kinetic_share == 0.0
    for estimate, true, off in (
        ("bridgman_flow", "flow_stress", 0.05),
        ("bridgman_axial", "axial_stress", 0.1),
    ):
        values = [at_elongation(run.history, name, 4e-3) for name in (estimate, true)]
        assert values[0] == pytest.approx(values[1], rel=off)
    centre, surface = (at_elongation(run.history, f"{at}_triaxiality", 4e-3) for at in ("centre", "surface"))
    assert centre > 0.45 > surface > 0.2


def test_an_eighth_of_a_bar_in_three_dimensions_necks_like_the_body_of_revolution():
    """Hex8 of the size of the quads: peak over the section of 16 corners within 0.3 %, neck at 4 mm within 1 %."""
    scene = replace(SIMO, pull=4e-3)
    plans = [
        PlannedRun("one", "fem-implicit", 4, 8, 0.25, kind=kind, increments=12) for kind in ("quad4", "hex8")
    ]
    plane, solid = (make_run(scene, plan) for plan in plans)
    section = 16.0 / (2.0 * math.pi) * math.sin(math.pi / 8.0)
    assert peak(solid.history)[1] == pytest.approx(section * peak(plane.history)[1], rel=3e-3)
    for name, within in (("neck_radius", 0.01), ("axial_stress", 0.05), ("bridgman_axial", 0.05)):
        ours, theirs = (at_elongation(run.history, name, 4e-3) for run in (solid, plane))
        assert ours == pytest.approx(theirs, rel=within)
    assert area(solid.shape) == pytest.approx(area(plane.shape), rel=0.01)


def test_a_square_bar_that_stays_straight_has_the_closed_form_of_the_largest_force():
    """A run of its own section, as large as the round one, in three dimensions: within 0.1 %."""
    half = 0.5 * math.sqrt(math.pi) * SIMO.radius
    plan = PlannedRun(
        "square", "fem-implicit", 1, 2, kind="hex8", increments=14, body="square-bar", radius=half, taper=1.0
    )
    run = make_run(replace(SIMO, pull=4.2e-3), plan)
    assert peak(run.history)[1] == pytest.approx(uniform_peak(SIMO.material, SIMO.radius), rel=1e-3)
    assert run.history.column("bridgman_flow").max() == 0.0


def area(shape):
    """Area of quads (n, 4, 2) [m^2]."""
    x, y = shape[..., 0], shape[..., 1]
    return 0.5 * float(np.abs((x * np.roll(y, -1, axis=1) - y * np.roll(x, -1, axis=1)).sum()))

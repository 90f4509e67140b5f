"""Loads that are given by their histories."""

import math

import numpy as np
import pytest

from core_models.loads import Prescribed, displaced


def test_a_prescribed_displacement_is_what_its_velocities_add_up_to():
    """The sum of velocity times step, each at the middle of its step, is u(t) - u(0) to round-off; at t = 0 too."""
    step = 1e-7
    load = displaced("top", 1, lambda t: 2e-3 * math.sin(1e4 * t), step)
    assert isinstance(load, Prescribed) and (load.boundary, load.component) == ("top", 1)
    velocities = [load.velocity(None, t) for t in step * (np.arange(200) + 0.5)]
    assert step * sum(velocities) == pytest.approx(2e-3 * math.sin(1e4 * 200 * step), rel=1e-12)
    assert load.velocity(None, 0.0) * step == pytest.approx(2e-3 * math.sin(1e4 * 0.5 * step), rel=1e-12)

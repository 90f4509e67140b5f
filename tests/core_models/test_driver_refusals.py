"""Loading programs that make no sense are refused, with the numbers."""

import numpy as np
import pytest

from core_models.driver import drive_program
from core_models.errors import RunFailure, SceneError
from core_models.loading import Deformation, Stress, Stretch, VelocityGradient
from core_models.loading_paths import uniaxial_stress
from core_models.loading_program import Program, Segment

UNUSABLE = {
    "no rate": (lambda: uniaxial_stress(0.3, 0.0), "positive, not 0.0 /s"),
    "negative rate": (lambda: uniaxial_stress(0.3, [1.0, -2.0]), "not 1.0, -2.0 /s"),
    "no rates": (lambda: uniaxial_stress(0.3, []), "strain rates must be positive"),
    "no strain": (lambda: uniaxial_stress(0.0, 1.0), "other than 0, not 0.0"),
    "endless strain": (lambda: uniaxial_stress(np.inf, 1.0), "not inf"),
    "huge steps": (lambda: uniaxial_stress(3.0, 1.0, steps=2), r"3 in 2 steps is 1.5 a step.*take 6 steps"),
    "no steps": (lambda: uniaxial_stress(0.3, 1.0, steps=0), "1 or more, not 0"),
    "half a step": (lambda: uniaxial_stress(0.3, 1.0, steps=1.5), "not 1.5"),
    "half a cycle": (lambda: uniaxial_stress(0.3, 1.0, cycles=0.5), "not 0.5"),
    "too many steps": (lambda: uniaxial_stress(0.3, 1.0, steps=10**7), "1000000 steps"),
    "too many segments": (lambda: uniaxial_stress(0.3, 1.0, steps=10**5, cycles=10), "1000000 steps at most"),
    "negative stretch": (lambda: Stretch(-0.5), "positive, not -0.5"),
    "a word": (lambda: Stress("high"), "not 'high'"),
    "not a number": (lambda: Deformation(float("nan")), "not nan"),
    "no time": (lambda: Segment(0.0, 1), "positive time, not 0.0 s"),
    "unknown component": (
        lambda: Segment(1.0, 1, {"44": Stress()}),
        "unknown component '44'; valid: 11, 12",
    ),
    "twice a stress": (
        lambda: Segment(1.0, 1, {"12": Stress(), "21": Stress()}),
        "stress 12 is the stress 21",
    ),
    "stretched shear": (lambda: Segment(1.0, 1, {"12": Stretch(1.1)}), "belongs to 11, 22 or 33"),
    "a bare number": (lambda: Segment(1.0, 1, {"11": 1.2}), "takes a Deformation, Stretch"),
    "no segment": (lambda: Program([]), "at least one segment"),
}


@pytest.mark.parametrize(("make", "told"), UNUSABLE.values(), ids=UNUSABLE)
def test_values_that_make_no_sense_are_refused(make, told):
    """Before anything is computed, in one line with the value."""
    with pytest.raises(SceneError, match=told) as refusal:
        make()
    assert "\n" not in str(refusal.value)


UNREACHABLE = {
    "huge step": (
        Segment(1.0, 2, {"11": Deformation(3.0)}),
        "F 11 by 1 in each of its 2 steps.*take 4 or more",
    ),
    "fast": (Segment(1.0, 2, {"12": VelocityGradient(5.0)}), "L dt 12 by 2.5 .*take 10 or more"),
    "crushed": (Segment(1.0, 2, {"22": Stretch(0.01)}), "ln stretch 22 by 2.303 "),
    "inside out": (Segment(1.0, 10, {"33": Deformation(-0.5)}), "det F = -0.5"),
    "vanishing": (Segment(1.0, 9, {"11": Stretch(lambda t: 1 - t)}), "not 0 at t = 1 s"),
}


@pytest.mark.parametrize(("segment", "told"), UNREACHABLE.values(), ids=UNREACHABLE)
def test_segments_that_lead_nowhere_are_refused(pool, segment, told):
    """Steps beyond 50 % and volumes that vanish, with the number of steps that would do."""
    with pytest.raises(SceneError, match=told):
        drive_program(pool["hyper-linear"], Program([segment]))


@pytest.mark.parametrize("value", [float("nan"), float("inf")])
@pytest.mark.parametrize("control", [Stress, VelocityGradient, Deformation, Stretch])
def test_functions_that_give_no_number_are_refused(pool, control, value):
    """Where they do so, with quantity and time; it never reaches the state."""
    program = Program([Segment(1.0, 2, {"11": control(lambda t: value)})])
    with pytest.raises(SceneError, match=r"11 gives (nan|inf) at t = 0.5 s"):
        drive_program(pool["hyper-linear"], program)


def test_too_large_a_turn_in_a_step_ends_the_run(pool):
    """Past a quarter turn the same velocity gradient has several steps that lead there: none is taken."""
    spin = {"12": VelocityGradient(lambda t: 1e4), "21": VelocityGradient(lambda t: -1e4)}
    with pytest.raises(RunFailure, match="L dt 12"):
        drive_program(pool["hyper-linear"], Program([Segment(1.0, 1, spin)]))

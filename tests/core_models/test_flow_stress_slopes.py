"""The slopes that flow laws hand to the local iteration."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core_models.laws import evolve_hardening, flow_stress

LAWS = ["perfect", "linear", "power", "voce", "jc", "mts"]
VARIABLES = ["hardening variable", "plastic strain", "plastic rate", "temperature"]
STATE = st.tuples(
    st.floats(1e6, 6e8),
    st.floats(1e-4, 2.0),
    st.floats(-2.0, 7.5).map(lambda power: 10.0**power),
    st.floats(250.0, 1300.0),
)


def difference(function, x, step):
    """Central difference of fourth order."""
    return (
        8.0 * (function(x + step) - function(x - step)) - function(x + 2 * step) + function(x - 2 * step)
    ) / (12.0 * step)


def crosses_a_kink(value, *kinks):
    """Whether a difference of 1e-3 of the value spans a kink of the law."""
    return any(abs(value - kink) < 3e-3 * value for kink in kinks)


@pytest.mark.parametrize("name", LAWS)
@pytest.mark.parametrize("variable", range(4), ids=VARIABLES)
@settings(max_examples=60, deadline=None)
@given(state=STATE)
def test_slopes_are_derivatives(flow_laws, name, variable, state):
    """Every slope of every flow law agrees with differences of the stress, to 1e-5 of stress over variable."""
    law = flow_laws[name]
    if crosses_a_kink(state[2], 1.0, 1e7) or crosses_a_kink(state[3], 294.0):
        return

    def stress(x):
        return flow_stress(law, *state[:variable], x, *state[variable + 1 :])[0]

    value, *slopes = flow_stress(law, *state)
    measured = difference(stress, state[variable], 1e-3 * state[variable])
    assert slopes[variable] * state[variable] == pytest.approx(
        measured * state[variable], rel=1e-3, abs=1e-5 * value
    )


@settings(max_examples=60, deadline=None)
@given(state=STATE, increment=st.floats(1e-6, 0.9e-3))
def test_threshold_slopes_are_derivatives(flow_laws, state, increment):
    """The slopes of the new threshold stress in the strain increment and in the rate, to 1e-3 of the change."""
    threshold, _strain, rate, temperature = state
    law = flow_laws["mts"]

    def by_increment(x):
        return evolve_hardening(law, threshold, x, rate, temperature)[0]

    def by_rate(x):
        return evolve_hardening(law, threshold, increment, x, temperature)[0]

    new, slope, rate_slope = evolve_hardening(law, threshold, increment, rate, temperature)
    scale = abs(new - threshold) + 1e-6 * threshold
    assert slope * increment == pytest.approx(
        difference(by_increment, increment, 1e-3 * increment) * increment, abs=1e-3 * scale
    )
    assert rate_slope * rate == pytest.approx(difference(by_rate, rate, 1e-3 * rate) * rate, abs=1e-3 * scale)


def test_below_the_slowest_rate_nothing_depends_on_it(flow_laws):
    """At rest the threshold law takes its lowest rate, and its slopes in the rate are zero."""
    law = flow_laws["mts"]
    assert flow_stress(law, 2e8, 0.1, 0.0, 300.0) == flow_stress(law, 2e8, 0.1, 1e-8, 300.0)
    assert flow_stress(law, 2e8, 0.1, 0.0, 300.0)[3] == 0.0
    assert evolve_hardening(law, 2e8, 1e-3, 0.0, 300.0) == evolve_hardening(law, 2e8, 1e-3, 1e-8, 300.0)
    assert evolve_hardening(law, 2e8, 1e-3, 0.0, 300.0)[2] == 0.0

"""Extrapolated limits of manufactured sequences."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from studies.comparisons.convergence import extrapolate

RESOLUTIONS = [6, 8, 12, 16, 24]


def sequence(limit, slope, order, resolutions=RESOLUTIONS):
    """Values limit + slope / N^order."""
    return [limit + slope / n**order for n in resolutions]


@pytest.mark.parametrize("order", [0.8, 1.0, 1.5, 2.0, 2.9])
def test_a_clean_sequence_gives_its_limit_and_order(order):
    """f0 + a h^p is found to the resolution of the search over p."""
    estimate = extrapolate(RESOLUTIONS, sequence(7.0, -3.0, order))
    gap = 3.0 / 24**order
    assert estimate.order == pytest.approx(order, abs=0.011)
    assert estimate.value == pytest.approx(7.0, abs=0.05 * gap)
    assert abs(estimate.value - 7.0) <= estimate.uncertainty <= gap


def test_three_values_are_enough():
    """With three resolutions the fit goes through all of them."""
    estimate = extrapolate([8, 12, 16], sequence(7.0, -3.0, 1.0, [8, 12, 16]))
    assert estimate.value == pytest.approx(7.0, abs=5e-3)
    assert estimate.uncertainty > 0.0


def test_the_order_of_the_runs_does_not_matter():
    """Fine to coarse gives what coarse to fine gives."""
    values = sequence(7.0, -3.0, 1.3)
    assert extrapolate(RESOLUTIONS[::-1], values[::-1]) == extrapolate(RESOLUTIONS, values)


@given(st.integers(0, 10_000), st.floats(0.7, 2.5), st.floats(0.0, 0.3))
def test_noise_stays_within_the_stated_uncertainty(seed, order, share):
    """With noise up to a third of the last change the true limit lies within three times the uncertainty."""
    clean = np.array(sequence(7.0, -3.0, order))
    noise = share * abs(clean[-1] - clean[-2]) * np.random.default_rng(seed).uniform(-1.0, 1.0, len(clean))
    estimate = extrapolate(RESOLUTIONS, list(clean + noise))
    assert abs(estimate.value - 7.0) <= 3.0 * estimate.uncertainty + 1e-12


def test_a_sequence_that_turns_gets_at_least_its_spread():
    """Values that are not monotone have no order, and an uncertainty of at least their spread."""
    values = [1.0, 1.4, 1.2, 1.3]
    estimate = extrapolate([6, 8, 12, 16], values)
    assert estimate.order is None
    assert estimate.uncertainty >= 0.4
    assert 1.0 <= estimate.value <= 1.6
    assert "not monotone" in estimate.basis


def test_an_order_at_the_end_of_its_range_is_called_doubtful():
    """A sequence that hardly converges is extrapolated with a larger uncertainty, and says so."""
    estimate = extrapolate(RESOLUTIONS, sequence(7.0, -3.0, 0.1))
    assert "doubtful" in estimate.basis
    assert estimate.uncertainty >= 2.0 * abs(estimate.value - sequence(7.0, -3.0, 0.1)[-1])


def test_two_values_assume_first_order():
    """Two resolutions give Richardson's limit for p = 1, doubted by the whole gap."""
    estimate = extrapolate([8, 16], sequence(7.0, -3.0, 1.0, [8, 16]))
    assert estimate.value == pytest.approx(7.0, rel=1e-12)
    assert estimate.uncertainty == pytest.approx(3.0 / 16.0)


def test_one_value_has_no_uncertainty():
    """One resolution is reported as it is, without any claim."""
    estimate = extrapolate([8], [7.0])
    assert (estimate.value, estimate.uncertainty) == (7.0, None)


def test_equal_values_are_their_own_limit():
    """A quantity that does not depend on resolution has no error from it."""
    estimate = extrapolate([8, 12, 16], [7.0, 7.0, 7.0])
    assert (estimate.value, estimate.uncertainty) == (7.0, 0.0)

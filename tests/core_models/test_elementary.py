"""Logarithm, exponential and power in plain arithmetic."""

import math

import numba
import numpy as np

from core_models.elementary import exponential, logarithm, power

ROUND_OFF = np.finfo(float).eps


@numba.njit(error_model="numpy")
def many(x, exponent):
    """All three functions in a loop that the compiler may take several points of at once."""
    results = np.empty((3, x.size))
    for i in range(x.size):
        results[0, i] = logarithm(x[i])
        results[1, i] = exponential(math.log(x[i]))
        results[2, i] = power(x[i], exponent)
    return results


def samples():
    """Numbers over the whole range, dense around 1."""
    random = np.random.default_rng(4)
    return np.concatenate(
        [np.exp(random.uniform(-600.0, 600.0, 2001)), 1.0 + random.uniform(-1e-3, 1e-3, 2000), [1.0]]
    )


def test_they_agree_with_the_c_library():
    """Two units in the last place; a power has the round-off of exponent times logarithm in its exponential."""
    x = samples()
    logarithms, _, powers = many(x, 0.31)
    assert np.all(np.abs(logarithms - np.log(x)) <= 2.0 * ROUND_OFF * np.abs(np.log(x)))
    exponents = np.linspace(-680.0, 680.0, 3001)
    ratios = np.array([exponential(y) / math.exp(y) for y in exponents])
    assert np.all(np.abs(ratios - 1.0) <= 2.0 * ROUND_OFF)
    assert np.all(np.abs(powers / x**0.31 - 1.0) <= 2.0 * ROUND_OFF * (1.0 + 0.31 * np.abs(np.log(x))))


def test_exact_values():
    """ln 1 = 0, exp 0 = 1, 1^y = 1 and 0^y = 0."""
    assert (logarithm(1.0), exponential(0.0), power(1.0, 1.09), power(0.0, 1.09)) == (0.0, 1.0, 1.0, 0.0)


def test_one_by_one_and_in_plain_python_give_the_same_bits():
    """A point's result depends on neither its neighbours in the loop nor the compiler."""
    x = samples()
    together = many(x, 0.31)
    for i in range(0, x.size, 97):
        assert np.array_equal(many(x[i : i + 1], 0.31)[:, 0], together[:, i])
        plain = [logarithm(x[i]), exponential(math.log(x[i])), power(x[i], 0.31)]
        assert np.array_equal(plain, together[:, i])

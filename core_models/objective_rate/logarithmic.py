"""The logarithmic rate."""

import math
from typing import NamedTuple

from core_models.compilation import beside_kernel, inside_kernel
from core_models.elementary import logarithm
from core_models.hencky import along, logarithm_along, logarithm_change
from core_models.principal_axes import principal
from core_models.tensors import congruence, minus, plus, symmetric_part, transposed
from core_models.updates.corotation import (
    back,
    corotated,
    corotated_change,
    gradient_change,
    half_spin,
    half_turned,
    stretching,
    turned_back,
    whole_spin,
)


class Logarithmic(NamedTuple):
    """The logarithmic rate: the one whose integral of the rate of deformation is the Hencky strain ln V.

        s_trial = Q H^2 [s_n + 2 G dev(d)] (Q H^2)^T,   d = (H^2)^T ln(U) H^2 - ln(V_0),   H = cay(M / 2)
        M = sum_ij (1 / y - 1 / sinh y) P_i d_m P_j,   y = ln(lambda_i / lambda_j)

    with principal stretches lambda_i and projections P_i of V_0, d_m the strain increment of Green and Naghdi's rate,
    and Q that of `HypoelasticPlastic`.

    Elastic states are s = 2 G dev(ln V) exactly, whatever the steps, so that closed cycles leave nothing; the turn of
    the stress in plastic flow is of first order in the step. Valid for any rotation in a step.
    Source: Xiao, Bruhns & Meyers, Acta Mech. 124 (1997) 89; Lehmann, Guo & Liang, Eur. J. Mech. A 10 (1991) 395.
    """


SMALL = 1e-3  # ln(lambda_i / lambda_j) below which a series gives what its two parts would lose


@corotated.register(Logarithmic)
def _(objective_rate, before, after, increment):
    return _followed(before, after, increment)


@beside_kernel
def _followed(before, after, increment):
    """What `corotated` returns; out of the loop over points, which no processor could take together anyway."""
    values, axes = principal(before)
    turn, whole = half_turned(_spin(values, axes, stretching(before, after)), increment)
    final = principal(after)
    reached = _turned_twice(turn, logarithm_along(final[0], final[1]))
    return minus(reached, logarithm_along(values, axes)), whole


@corotated_change.register(Logarithmic)
def _(objective_rate, before, after, over_sum, change, spin):
    values, axes = principal(before)
    vector = _spin(values, axes, stretching(before, after))
    vector_change = _spin(values, axes, symmetric_part(gradient_change(before, over_sum, change)))
    turn = half_turned(vector, (1.0, 0.0, 0.0, 0.0))[0]
    half = half_spin(vector, vector_change)
    back_half = back(turn, half)
    whole = (back_half[0] + half[0], back_half[1] + half[1], back_half[2] + half[2])
    final = principal(after)
    moved = _turned_twice(turn, logarithm_change(final[0], final[1], change))
    reached = _turned_twice(turn, logarithm_along(final[0], final[1]))
    return plus(moved, turned_back(reached, whole)), whole_spin(turn, spin, half)


@inside_kernel
def _turned_twice(turn, s):
    return congruence(transposed(turn), congruence(transposed(turn), s))


@inside_kernel
def _spin(values, axes, strain):
    """Vector of M, from the principal stretches and axes before the step."""
    d = congruence(transposed(axes), strain)
    x, y, z = logarithm(values[0]), logarithm(values[1]), logarithm(values[2])
    return along(axes, (_factor(z - y) * d[4], _factor(x - z) * d[5], _factor(y - x) * d[3]))


@inside_kernel
def _factor(y):
    """1 / y - 1 / sinh y."""
    if abs(y) < SMALL:
        return y * (1.0 / 6.0 - y * y * (7.0 / 360.0))
    return 1.0 / y - 1.0 / math.sinh(y)

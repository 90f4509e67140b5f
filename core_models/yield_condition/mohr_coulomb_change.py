"""Linearisation of the return to Mohr and Coulomb's surface."""

import math

from core_models.compilation import beside_kernel, inside_kernel
from core_models.principal_axes import principal, to_principal
from core_models.tensors import congruence, determinant
from core_models.updates.general_problem import ELASTIC, NO_STRESS, return_change, strength
from core_models.yield_condition.apex import apex_change
from core_models.yield_condition.mohr_coulomb import MohrCoulomb
from core_models.yield_condition.mohr_coulomb_planes import (
    APEX,
    PLANES,
    dot,
    flow_on,
    plane,
    plastic_strain,
    shifted_values,
    slopes_of_excess,
    solved,
)
from core_models.yield_condition.mohr_coulomb_return import apex_of

CLOSE = 1e-6  # of the largest principal stress: principal values that count as equal


@return_change.register(MohrCoulomb)
def _(yield_condition, model, flow, problem, returned, rows, k, trial, shear, mean, spin):
    if returned.regime == ELASTIC:
        return trial, mean
    values, axes = principal(problem.trial)
    change = to_principal(trial, axes)
    if returned.regime >= APEX:
        return NO_STRESS, _apex_change(yield_condition, flow, problem, returned, values, change, shear, mean)
    return _change(yield_condition, model, flow, problem, returned, values, axes, change, shear, mean)


@inside_kernel
def _apex_change(law, flow, problem, returned, values, change, shear, mean):
    """Change of the mean stress at the apex [Pa]."""
    size, growth = math.sqrt(dot(values, values) / 6.0), 0.0
    if size > 0.0:
        growth = dot(values, change) / (6.0 * size * problem.shear)
    sheared = growth - size / problem.shear * shear / problem.shear
    return apex_change(apex_of(law), returned.regime - APEX, flow, problem, returned, sheared, mean)


@beside_kernel
def _change(law, model, flow, problem, returned, values, axes, change, shear, mean):
    """Change of deviator and mean stress on some planes: of the principal stresses, and of their axes."""
    planes = PLANES[returned.regime - 1]
    _converged, gammas, now, increment, _limit = flow_on(law, model, flow, problem, values, planes)
    hardening = strength(flow, problem, increment).slope
    matrix = slopes_of_excess(law, problem, planes, now, hardening)
    strain = plastic_strain(law, planes, gammas)
    values_change, mean_change = _principal_change(
        law, problem, planes, now, matrix, strain, change, shear, mean
    )
    deviator = shifted_values(values_change, -mean_change)
    s = (
        deviator[0], deviator[1], deviator[2],
        change[3] * _turning(law, problem, planes, now, matrix, strain, values, 0, 1),
        change[4] * _turning(law, problem, planes, now, matrix, strain, values, 1, 2),
        change[5] * _turning(law, problem, planes, now, matrix, strain, values, 2, 0),
    )  # fmt: skip
    return congruence(axes, s), mean_change


@beside_kernel
def _principal_change(law, problem, planes, now, matrix, strain, change, shear, mean):
    """Change of principal and mean stresses for that of the trial, the shear modulus and the mean stress."""
    g = 2.0 * shear
    bare = (
        change[0] - g * strain[0] + mean,
        change[1] - g * strain[1] + mean,
        change[2] - g * strain[2] + mean,
    )
    right = (
        _along(law, planes[0], bare),
        _along(law, planes[1], bare),
        _along(law, planes[2], bare),
    )
    moved = plastic_strain(law, planes, solved(matrix, determinant(matrix), right))
    growth = moved[3]
    g = 2.0 * problem.shear
    p = now.bulk * growth
    total = (bare[0] - g * moved[0] - p, bare[1] - g * moved[1] - p, bare[2] - g * moved[2] - p)
    return total, mean - p


@inside_kernel
def _along(law, index, change):
    """Change of the excess over a plane by that of the stresses."""
    return dot(plane(law.friction_angle, index), change)


@inside_kernel
def _turning(law, problem, planes, now, matrix, strain, values, i, j):
    """(s_i - s_j) / (t_i - t_j) of stresses s and trial stresses t, and its limit where the latter are equal."""
    gap = values[i] - values[j]
    if abs(gap) > CLOSE * (values[0] - values[2]):
        return (now.stress[i] - now.stress[j]) / gap
    towards = (unit(0, i) - unit(0, j), unit(1, i) - unit(1, j), unit(2, i) - unit(2, j))
    change, _mean = _principal_change(law, problem, planes, now, matrix, strain, towards, 0.0, 0.0)
    return 0.5 * (change[i] - change[j])


@inside_kernel
def unit(number, component):
    """1 for equal numbers, else 0."""
    return 1.0 if number == component else 0.0

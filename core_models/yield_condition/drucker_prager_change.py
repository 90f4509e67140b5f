"""Linearisation of the return to Drucker and Prager's surface."""

from core_models.compilation import inside_kernel
from core_models.tensors import contract
from core_models.updates.general_problem import ELASTIC, return_change, strength
from core_models.yield_condition.drucker_prager import OVER_ROOT_3, DruckerPrager
from core_models.yield_condition.drucker_prager_return import CONE, PLANE, is_apex
from core_models.yield_condition.shifted import deviator_change, shifted_before, shifted_change


@return_change.register(DruckerPrager)
def _(yield_condition, model, flow, problem, returned, rows, k, trial, shear, mean, spin):
    if returned.regime == ELASTIC:
        return trial, mean
    if returned.regime == PLANE:
        return trial, 0.0
    now = shifted_before(model.kinematic_hardening, problem, returned, rows, k)
    shift = shifted_change(now, trial, spin)
    size_change = OVER_ROOT_3 * 1.5 * contract(now.direction, shift)
    gamma_change, mean_change = _flow_change(
        yield_condition, flow, problem, returned, now.slope / 3.0, size_change, shear, mean
    )
    growth = OVER_ROOT_3 * gamma_change
    return deviator_change(now, problem, returned.increment, shift, trial, shear, growth), mean_change


@inside_kernel
def _flow_change(law, flow, problem, returned, slope, size_change, shear, mean):
    """Change of dgamma and of the mean stress.

    Parameters
    ----------
    slope, size_change : slope of [q(xi_trial) - R] / sqrt(3) by dgamma, and its change at a constant dgamma [Pa].
    """
    gamma = returned.increment / OVER_ROOT_3
    now = strength(flow, problem, returned.increment)
    hardening = law.cohesion_factor * now.slope * OVER_ROOT_3
    bare, stiffness = size_change - gamma * shear, problem.shear - slope
    a, b = 3.0 * law.alpha, 3.0 * law.beta
    if returned.regime == CONE:
        gamma_change = (bare + a * mean) / (stiffness + a * b * returned.bulk + hardening)
        return gamma_change, mean - returned.bulk * b * gamma_change
    if is_apex(law, law.cohesion_factor * now.stress):
        gamma_change = bare / stiffness
        return gamma_change, hardening * gamma_change / a
    return bare / (stiffness + hardening), 0.0

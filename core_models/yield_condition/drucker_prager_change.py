"""Linearisation of the return to Drucker and Prager's surface."""

from core_models.compilation import inside_kernel
from core_models.tensors import contract, equivalent_stress, minus
from core_models.updates.general_problem import ELASTIC, return_change, strength
from core_models.yield_condition.apex import apex_change
from core_models.yield_condition.drucker_prager import OVER_ROOT_3, DruckerPrager
from core_models.yield_condition.drucker_prager_return import APEX, CONE, PLANE, apex_of
from core_models.yield_condition.shifted import (
    change_without_shift,
    deviator_change,
    shifted_before,
    shifted_change,
)

ROUND_OFF = 1e-12  # of the trial stress: a loss of shear stress below it has no direction


@return_change.register(DruckerPrager)
def _(yield_condition, model, flow, problem, returned, rows, k, trial, shear, mean, spin):
    if returned.regime == ELASTIC or (returned.regime == CONE and returned.increment == 0.0):
        return trial, mean
    if returned.regime == PLANE:
        return trial, 0.0
    hardening, sheared = model.kinematic_hardening, returned.increment
    if returned.regime >= APEX:
        lost = equivalent_stress(minus(problem.trial, returned.deviator))
        sheared = lost / (3.0 * problem.shear)
        if lost <= ROUND_OFF * equivalent_stress(problem.trial):
            deviator = change_without_shift(hardening, problem, rows, k, trial, spin)
            return deviator, _at_apex(yield_condition, flow, problem, returned, 0.0, mean)
    now = shifted_before(hardening, problem, returned.deviator, sheared, rows, k)
    shift = shifted_change(now.rest, trial, spin)
    size_change = OVER_ROOT_3 * 1.5 * contract(now.direction, shift)
    bare, stiffness = size_change - sheared / OVER_ROOT_3 * shear, problem.shear - now.slope / 3.0
    gamma_change, mean_change = _flow_change(yield_condition, flow, problem, returned, bare, stiffness, mean)
    growth = OVER_ROOT_3 * gamma_change
    return deviator_change(now, problem, sheared, shift, trial, shear, growth), mean_change


@inside_kernel
def _flow_change(law, flow, problem, returned, bare, stiffness, mean):
    """Change of dgamma and of the mean stress.

    Parameters
    ----------
    bare, stiffness : change of q(xi) / sqrt(3) at a constant dgamma, and its fall by dgamma [Pa].
    """
    if returned.regime >= APEX:
        gamma_change = bare / stiffness
        return gamma_change, _at_apex(law, flow, problem, returned, OVER_ROOT_3 * gamma_change, mean)
    stiffness += law.cohesion_factor * strength(flow, problem, returned.increment).slope * OVER_ROOT_3
    if returned.regime != CONE:
        return bare / stiffness, 0.0
    a, b = 3.0 * law.alpha, 3.0 * law.beta
    gamma_change = (bare + a * mean) / (stiffness + a * b * returned.bulk)
    return gamma_change, mean - returned.bulk * b * gamma_change


@inside_kernel
def _at_apex(law, flow, problem, returned, sheared, mean):
    """Change of the mean stress at the apex [Pa]."""
    return apex_change(apex_of(law), returned.regime - APEX, flow, problem, returned, sheared, mean)

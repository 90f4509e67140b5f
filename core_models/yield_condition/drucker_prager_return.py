"""Return to Drucker and Prager's cone, its apex and its cut-off, about a back stress where there is one.

With dp = dgamma / sqrt(3) and xi of core_models.yield_condition.shifted:

    cone:     q(xi) / sqrt(3) + 3 alpha m(ln J_e - 3 beta dgamma) = k(dp)
    cut-off:  m = M;   q(xi) / sqrt(3) <= k(dp) - 3 alpha M
    apex:     q(xi) = 0;   m = k(dp) / (3 alpha) or M;   dp by dgamma or, as core_models.yield_condition.apex says, by
              the growth of the volume, dv / (3 sqrt(3) alpha)
"""

from core_models.compilation import beside_kernel, inside_kernel
from core_models.tensors import minus, scaled
from core_models.updates.back_stress import move_back_stresses
from core_models.updates.general_problem import (
    Returned,
    allowance,
    mean_stress,
    return_stress,
    status_of,
    strength,
    unchanged,
    volume_at,
)
from core_models.updates.root import next_guess
from core_models.yield_condition.apex import Apex, apex_flow
from core_models.yield_condition.drucker_prager import OVER_ROOT_3, DruckerPrager
from core_models.yield_condition.shifted import shifted

MAXIMUM_ITERATIONS = 100
# Regimes: the cone, where it meets the cut-off, the cut-off alone; from the last on the kinds of flow at the apex.
CONE, EDGE, PLANE, APEX = 1, 2, 3, 4


@return_stress.register(DruckerPrager)
def _(yield_condition, model, flow, problem, rows, k):
    stress, bulk = mean_stress(model.eos, problem, problem.volume)
    size = OVER_ROOT_3 * shifted(model.kinematic_hardening, problem, 0.0, rows, k).size
    cone = yield_condition.cohesion_factor * strength(flow, problem, 0.0).stress
    if size + 3.0 * yield_condition.alpha * stress <= cone and stress <= yield_condition.tension_cutoff:
        return unchanged(problem, stress, bulk)
    return _returned(yield_condition, model, flow, problem, size, rows, k)


@beside_kernel
def _returned(law, model, flow, problem, size, rows, k):
    """Return to the cone; where that ends beyond the largest mean stress, to this, along the cone as far as needed."""
    hardening, regime = model.kinematic_hardening, CONE
    highest = _without_shear(hardening, problem, size, rows, k)
    converged, gamma, volume, stress, bulk = _on_cone(law, model, flow, problem, size, highest, rows, k)
    increment = sheared = gamma * OVER_ROOT_3
    if not converged or stress > law.tension_cutoff:
        apex, most = apex_of(law), highest * OVER_ROOT_3
        if strength(flow, problem, most).stress <= apex.friction * apex.cutoff:
            end = apex_flow(apex, model.eos, flow, problem, most)
            regime, sheared, increment = APEX + end.kind, most, end.increment
            converged, volume, stress, bulk = end.converged, end.volume, end.mean_stress, end.bulk
        else:
            converged, gamma = _on_edge(law, hardening, flow, problem, highest, rows, k)
            regime = EDGE if gamma > 0.0 else PLANE
            increment = sheared = gamma * OVER_ROOT_3
            limit = allowance(problem, strength(flow, problem, increment).stress * law.cohesion_factor, bulk)
            volume, stress, bulk = volume_at(model.eos, problem, law.tension_cutoff, limit)
            converged = converged and abs(stress - law.tension_cutoff) <= 10.0 * limit
    direction = shifted(hardening, problem, sheared, rows, k).direction
    stored = move_back_stresses(hardening, sheared, direction, rows, k) if converged else 0.0
    deviator = minus(problem.trial, scaled(direction, 3.0 * problem.shear * sheared))
    return Returned(
        status_of(converged), regime, deviator, volume, stress, bulk, increment,
        strength(flow, problem, increment).variable, problem.porosity, stored,
    )  # fmt: skip


@inside_kernel
def apex_of(law):
    """Apex of the cone: `Apex`."""
    slope = 3.0 * law.alpha
    return Apex(slope / law.cohesion_factor, slope / OVER_ROOT_3, law.tension_cutoff)


@inside_kernel
def _left(hardening, problem, gamma, rows, k):
    """q(xi) / sqrt(3) after a flow dgamma, and its slope by it [Pa]."""
    at = shifted(hardening, problem, gamma * OVER_ROOT_3, rows, k)
    return OVER_ROOT_3 * at.reached - problem.shear * gamma, at.slope / 3.0 - problem.shear


@beside_kernel
def _without_shear(hardening, problem, size, rows, k):
    """The dgamma at which nothing is left of xi."""
    low, high = 0.0, size / problem.shear
    if _left(hardening, problem, high, rows, k)[0] == 0.0:
        return high
    for _doubling in range(MAXIMUM_ITERATIONS):
        if _left(hardening, problem, high, rows, k)[0] <= 0.0:
            break
        low, high = high, 2.0 * high
    gamma = high
    for _iteration in range(MAXIMUM_ITERATIONS):
        left, slope = _left(hardening, problem, gamma, rows, k)
        if left == 0.0 or high - low <= 1e-15 * high:
            break
        if left > 0.0:
            low = gamma
        else:
            high = gamma
        gamma = next_guess(gamma, left, slope, low, high)
    return gamma


@beside_kernel
def _on_cone(law, model, flow, problem, size, highest, rows, k):
    """Root of q(xi) / sqrt(3) + 3 alpha m(ln J_e - 3 beta dgamma) - k(dgamma), which falls with dgamma."""
    low, high = 0.0, highest
    gamma = high
    for _iteration in range(MAXIMUM_ITERATIONS):
        left, left_slope = _left(model.kinematic_hardening, problem, gamma, rows, k)
        volume = problem.volume - 3.0 * law.beta * gamma
        stress, bulk = mean_stress(model.eos, problem, volume)
        now = strength(flow, problem, gamma * OVER_ROOT_3)
        cohesion = law.cohesion_factor * now.stress
        residual = left + 3.0 * law.alpha * stress - cohesion
        is_near = abs(residual) <= allowance(problem, cohesion, bulk)
        is_beyond = residual > 0.0 and (not is_near or 3.0 * law.alpha * stress > cohesion)
        if gamma == highest and is_beyond:
            break
        if is_near or high - low <= 1e-15 * high:
            return True, gamma, volume, stress, bulk
        if residual > 0.0:
            low = gamma
        else:
            high = gamma
        slope = left_slope - 9.0 * law.alpha * law.beta * bulk - law.cohesion_factor * now.slope * OVER_ROOT_3
        gamma = next_guess(gamma, residual, slope, low, high)
    return False, gamma, problem.volume, 0.0, bulk


@beside_kernel
def _on_edge(law, hardening, flow, problem, highest, rows, k):
    """Flow where the cone meets the cut-off: root of q(xi) / sqrt(3) - [k - 3 alpha M], which falls with dgamma."""
    low, high = 0.0, highest
    gamma = 0.0
    for _iteration in range(MAXIMUM_ITERATIONS):
        left, left_slope = _left(hardening, problem, gamma, rows, k)
        now = strength(flow, problem, gamma * OVER_ROOT_3)
        cohesion = law.cohesion_factor * now.stress
        residual = left - max(cohesion - 3.0 * law.alpha * law.tension_cutoff, 0.0)
        is_inside = gamma == 0.0 and residual <= 0.0
        if is_inside or abs(residual) <= allowance(problem, cohesion, 0.0) or high - low <= 1e-15 * high:
            return True, gamma
        if residual > 0.0:
            low = gamma
        else:
            high = gamma
        slope = left_slope - law.cohesion_factor * now.slope * OVER_ROOT_3
        gamma = next_guess(gamma, residual, slope, low, high) if gamma > 0.0 else high
    return False, gamma

"""Von Mises yield condition about a back stress: the return of kinematic hardening."""

from core_models.compilation import beside_kernel, inside_kernel
from core_models.tensors import contract, minus, scaled
from core_models.updates.back_stress import move_back_stresses
from core_models.updates.general_problem import (
    ELASTIC,
    Returned,
    allowance,
    mean_stress,
    return_change,
    return_stress,
    status_of,
    strength,
    unchanged,
)
from core_models.updates.root import next_guess
from core_models.yield_condition.shifted import deviator_change, shifted, shifted_before, shifted_change
from core_models.yield_condition.von_mises import VonMises

MAXIMUM_ITERATIONS = 100
PLASTIC = 1  # regime


@return_stress.register(VonMises)
def _(yield_condition, model, flow, problem, rows, k):
    """With the direction of flow given by the shifted trial stress, one equation for dp:

    q(xi_trial) - R - 3 G dp = sigma_y(dp)
    """
    hardening = model.kinematic_hardening
    stress, bulk = mean_stress(model.eos, problem, problem.volume)
    if shifted(hardening, problem, 0.0, rows, k).size <= strength(flow, problem, 0.0).stress:
        return unchanged(problem, stress, bulk)
    has_converged, increment = _search(hardening, flow, problem, rows, k)
    direction = shifted(hardening, problem, increment, rows, k).direction
    stored = move_back_stresses(hardening, increment, direction, rows, k) if has_converged else 0.0
    deviator = minus(problem.trial, scaled(direction, 3.0 * problem.shear * increment))
    return Returned(
        status_of(has_converged), PLASTIC, deviator, problem.volume, stress, bulk, increment,
        strength(flow, problem, increment).variable, problem.porosity, stored,
    )  # fmt: skip


@beside_kernel
def _search(hardening, flow, problem, rows, k):
    """The increment of plastic strain, whose residual falls with it."""
    start = shifted(hardening, problem, 0.0, rows, k)
    low, high = 0.0, 0.0
    for _doubling in range(MAXIMUM_ITERATIONS):
        high = 2.0 * high + start.size / problem.shear
        if _residual(hardening, flow, problem, high, rows, k)[0] < 0.0:
            break
    increment = (start.size - strength(flow, problem, 0.0).stress) / (3.0 * problem.shear)
    for _iteration in range(MAXIMUM_ITERATIONS):
        residual, slope, surface = _residual(hardening, flow, problem, increment, rows, k)
        if abs(residual) <= allowance(problem, surface, 0.0) or high - low <= 1e-15 * high:
            return True, increment
        if residual > 0.0:
            low = increment
        else:
            high = increment
        increment = next_guess(increment, residual, slope, low, high)
    return False, 0.0


@inside_kernel
def _residual(hardening, flow, problem, increment, rows, k):
    """Residual of the equation for dp, its slope, and R + sigma_y."""
    at = shifted(hardening, problem, increment, rows, k)
    now = strength(flow, problem, increment)
    residual = at.reached - 3.0 * problem.shear * increment - now.stress
    return residual, at.slope - 3.0 * problem.shear - now.slope, at.size - at.reached + now.stress


@return_change.register(VonMises)
def _(yield_condition, model, flow, problem, returned, rows, k, trial, shear, mean, spin):
    if returned.regime == ELASTIC:
        return trial, mean
    increment = returned.increment
    now = shifted_before(model.kinematic_hardening, problem, returned.deviator, increment, rows, k)
    shift = shifted_change(now.rest, trial, spin)
    stiffness = 3.0 * problem.shear + strength(flow, problem, increment).slope - now.slope
    growth = (1.5 * contract(now.direction, shift) - 3.0 * increment * shear) / stiffness
    return deviator_change(now, problem, increment, shift, trial, shear, growth), mean

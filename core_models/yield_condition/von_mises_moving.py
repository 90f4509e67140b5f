"""Von Mises yield condition about a back stress: the return of kinematic hardening."""

from core_models.compilation import beside_kernel, inside_kernel
from core_models.rotation import slightly_turned
from core_models.tensors import contract, equivalent_stress, minus, plus, scaled
from core_models.updates.back_stress import (
    move_back_stresses,
    reach,
    recovered,
    recovered_before,
)
from core_models.updates.general_problem import (
    ELASTIC,
    Returned,
    mean_stress,
    return_change,
    return_stress,
    status_of,
    strength,
    unchanged,
)
from core_models.yield_condition.von_mises import VonMises

MAXIMUM_ITERATIONS = 100
PLASTIC = 1  # regime


@return_stress.register(VonMises)
def _(yield_condition, model, flow, problem, rows, k):
    """With xi = s - sum alpha exp(-gamma dp), which gives the direction of flow, one equation for dp:

    q(xi) - 3 G dp - sum C [1 - exp(-gamma dp)] / gamma = sigma_y(dp)
    """
    stress, bulk = mean_stress(model.eos, problem, problem.volume)
    xi = minus(problem.trial, recovered(model.kinematic_hardening, 0.0, rows, k)[0])
    if equivalent_stress(xi) <= strength(flow, problem, 0.0).stress:
        return unchanged(problem, stress, bulk)
    has_converged, increment, direction, variable = _search(model.kinematic_hardening, flow, problem, rows, k)
    stored = (
        move_back_stresses(model.kinematic_hardening, increment, direction, rows, k) if has_converged else 0.0
    )
    deviator = minus(problem.trial, scaled(direction, 3.0 * problem.shear * increment))
    return Returned(
        status_of(has_converged), PLASTIC, deviator, problem.volume, stress, bulk, increment, variable,
        problem.porosity, stored,
    )  # fmt: skip


@beside_kernel
def _search(kinematic_hardening, flow, problem, rows, k):
    """The increment of plastic strain, whose residual falls with it, and xi / q(xi)."""
    xi = minus(problem.trial, recovered(kinematic_hardening, 0.0, rows, k)[0])
    low, high = 0.0, 0.0
    for _doubling in range(MAXIMUM_ITERATIONS):
        high = 2.0 * high + equivalent_stress(xi) / problem.shear
        if _residual(kinematic_hardening, flow, problem, high, rows, k)[0] < 0.0:
            break
    increment = 0.0
    for _iteration in range(MAXIMUM_ITERATIONS):
        residual, slope, size, direction, variable = _residual(
            kinematic_hardening, flow, problem, increment, rows, k
        )
        if abs(residual) <= problem.tolerance * size or high - low <= 1e-15 * high:
            return True, increment, direction, variable
        if residual > 0.0:
            low = increment
        else:
            high = increment
        increment -= residual / slope
        if not low < increment < high:
            increment = 0.5 * (low + high)
    return False, 0.0, problem.trial, problem.hardening_variable


@inside_kernel
def _residual(kinematic_hardening, flow, problem, increment, rows, k):
    """Residual of the equation for dp, its slope, q(xi), xi / q(xi) and the hardening variable."""
    total, falling = recovered(kinematic_hardening, increment, rows, k)
    xi = minus(problem.trial, total)
    size = equivalent_stress(xi)
    direction = scaled(xi, 1.0 / size)
    added, added_slope = reach(kinematic_hardening, increment)
    now = strength(flow, problem, increment)
    residual = size - 3.0 * problem.shear * increment - added - now.stress
    slope = 1.5 * contract(direction, falling) - 3.0 * problem.shear - added_slope - now.slope
    return residual, slope, size, direction, now.variable


@return_change.register(VonMises)
def _(yield_condition, model, flow, problem, returned, rows, k, trial, shear, mean, spin):
    if returned.regime == ELASTIC:
        return trial, mean
    increment = returned.increment
    direction = scaled(minus(problem.trial, returned.deviator), 1.0 / (3.0 * problem.shear * increment))
    total, falling = recovered_before(model.kinematic_hardening, increment, direction, rows, k)
    size = equivalent_stress(minus(problem.trial, total))
    stiffness = 3.0 * problem.shear + reach(model.kinematic_hardening, increment)[1]
    stiffness += strength(flow, problem, increment).slope - 1.5 * contract(direction, falling)
    shift = minus(trial, scaled(minus(total, slightly_turned(total, spin)), 2.0))
    growth = (1.5 * contract(direction, shift) - 3.0 * increment * shear) / stiffness
    xi = plus(shift, scaled(falling, growth))
    turning = scaled(minus(xi, scaled(direction, 1.5 * contract(direction, xi))), 1.0 / size)
    taken = plus(
        scaled(direction, 3.0 * (problem.shear * growth + shear * increment)),
        scaled(turning, 3.0 * problem.shear * increment),
    )
    return minus(trial, taken), mean

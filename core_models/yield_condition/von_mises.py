"""Von Mises yield condition and its radial return."""

from typing import NamedTuple

from core_models.compilation import inside_kernel
from core_models.laws import evolve_hardening, flow_stress, return_to_surface
from core_models.status import NOT_CONVERGED, OK
from core_models.tensors import equivalent_stress

MAXIMUM_ITERATIONS = 60


class VonMises(NamedTuple):
    """Von Mises yield condition: q = sqrt(3/2 s:s) <= sigma_y, with associated flow.

    The stress measure is that of the update which calls it: Cauchy in the hypoelastic, Kirchhoff in the hyperelastic.
    """


@inside_kernel
def _consistency(
    flow, trial, shear_3, plastic_strain, hardening_variable, dt, temperature, increment
):
    """Residual q_trial - 3G dp - sigma_y and its slope; flow stress; hardening variable and its slope, all at dp."""
    rate = increment / dt
    variable, variable_slope, variable_rate = evolve_hardening(
        flow, hardening_variable, increment, rate, temperature
    )
    stress, by_variable, by_strain, by_rate, _by_temperature = flow_stress(
        flow, variable, plastic_strain + increment, rate, temperature
    )
    variable_slope += variable_rate / dt
    slope = by_strain + by_rate / dt + by_variable * variable_slope
    return trial - shear_3 * increment - stress, -shear_3 - slope, stress, variable, variable_slope


@return_to_surface.register(VonMises)
def _(
    yield_condition, flow, trial, shear_3, stress_before, plastic_strain, hardening_variable, dt, temperature,
    tolerance,
):  # fmt: skip
    """Radial return: q_trial - 3 G dp = sigma_y(ep + dp, dp/dt, T), solved by Newton steps kept inside a bracket.

    The first guess lets the flow stress stay what it was. A last Newton step is accepted without another look at the
    flow law once its second-order remainder is below the tolerance.
    """
    q = equivalent_stress(trial)
    yield_stress = flow_stress(flow, hardening_variable, plastic_strain, 0.0, temperature)[0]
    if q <= yield_stress:
        return 1.0, 0.0, yield_stress, hardening_variable, OK
    low, high = 0.0, (q - yield_stress) / shear_3
    increment = min(high, (q - stress_before) / shear_3) if stress_before < q else high
    limit = tolerance * q
    for _iteration in range(MAXIMUM_ITERATIONS):
        residual, slope, stress, variable, variable_slope = _consistency(
            flow, q, shear_3, plastic_strain, hardening_variable, dt, temperature, increment
        )
        if abs(residual) <= limit:
            return stress / q, increment, stress, variable, OK
        if residual > 0.0:
            low = increment
        else:
            high = increment
        step = -residual / slope
        hardening = -(slope + shear_3) * step
        if low < increment + step < high:
            if abs(hardening * step) <= limit * increment:
                stress += hardening
                return stress / q, increment + step, stress, variable + variable_slope * step, OK
            increment += step
        else:
            increment = 0.5 * (low + high)
        if high - low <= 1e-15 * high:
            return stress / q, increment, stress, variable, OK
    return 1.0, 0.0, yield_stress, hardening_variable, NOT_CONVERGED


@return_to_surface.register(type(None))
def _(
    yield_condition, flow, trial, shear_3, stress_before, plastic_strain, hardening_variable, dt, temperature,
    tolerance,
):  # fmt: skip
    return 1.0, 0.0, 0.0, hardening_variable, OK

"""Von Mises yield condition and its radial return."""

from typing import NamedTuple

from core_models.compilation import inside_kernel
from core_models.laws import evolve_hardening, flow_stress, return_to_surface
from core_models.status import NOT_CONVERGED, OK

MAXIMUM_ITERATIONS = 100


class VonMises(NamedTuple):
    """Von Mises yield condition: trial = sqrt(3/2 s:s) <= sigma_y, with associated flow.

    The stress measure is that of the update which calls it: Cauchy in the hypoelastic, Kirchhoff in the hyperelastic.
    """


@inside_kernel
def _consistency(flow, trial, shear_3, plastic_strain, hardening_variable, over_dt, temperature, increment):
    """Residual q_trial - 3G dp - sigma_y and its slope; flow stress; hardening variable and its slope, all at dp."""
    rate = increment * over_dt
    variable, variable_slope, variable_rate = evolve_hardening(
        flow, hardening_variable, increment, rate, temperature
    )
    stress, by_variable, by_strain, by_rate, _by_temperature = flow_stress(
        flow, variable, plastic_strain + increment, rate, temperature
    )
    variable_slope += variable_rate * over_dt
    slope = by_strain + by_rate * over_dt + by_variable * variable_slope
    return trial - shear_3 * increment - stress, -shear_3 - slope, stress, variable, variable_slope


@return_to_surface.register(VonMises)
def _(
    yield_condition, flow, trial, shear_3, stress_before, plastic_strain, hardening_variable, over_dt, temperature,
    tolerance,
):  # fmt: skip
    """Radial return: q_trial - 3 G dp = sigma_y(ep + dp, dp/dt, T), solved by Newton steps kept inside a bracket.

    The first guess lets the stress stay what it was. A Newton step is the last one, without another look at the flow
    law, once its second-order remainder is below the tolerance. A step towards dp <= 0 asks whether there is a root
    at all: there is none for q_trial <= sigma_y(ep, 0, T), the elastic case.
    """
    over_shear = 1.0 / shear_3
    low, high = 0.0, 2.0 * trial * over_shear  # the root is at trial / shear_3 at most
    increment = (trial - stress_before) * over_shear
    limit = tolerance * trial
    is_plastic = False
    for _iteration in range(MAXIMUM_ITERATIONS):
        if increment <= low or increment >= high:
            if not is_plastic:
                yield_stress = flow_stress(flow, hardening_variable, plastic_strain, 0.0, temperature)[0]
                if trial <= yield_stress:
                    return 1.0, 0.0, yield_stress, hardening_variable, OK
                is_plastic = True
            increment = 0.5 * (low + high)
        residual, slope, stress, variable, variable_slope = _consistency(
            flow, trial, shear_3, plastic_strain, hardening_variable, over_dt, temperature, increment
        )
        if abs(residual) <= limit:
            return stress / trial, increment, stress, variable, OK
        if residual > 0.0:
            low = increment
        else:
            high = increment
        step = -residual / slope
        hardening = -(slope + shear_3) * step
        if low < increment + step < high and abs(hardening * step) <= limit * increment:
            stress += hardening
            return stress / trial, increment + step, stress, variable + variable_slope * step, OK
        if high - low <= 1e-15 * high:
            return stress / trial, increment, stress, variable, OK
        increment += step
    return 1.0, 0.0, 0.0, hardening_variable, NOT_CONVERGED


@return_to_surface.register(type(None))
def _(
    yield_condition, flow, trial, shear_3, stress_before, plastic_strain, hardening_variable, over_dt, temperature,
    tolerance,
):  # fmt: skip
    return 1.0, 0.0, 0.0, hardening_variable, OK

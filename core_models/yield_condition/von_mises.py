"""Von Mises yield condition and its radial return."""

import math
from typing import NamedTuple

from core_models.compilation import beside_kernel, inside_kernel
from core_models.laws import evolve_hardening, flow_stress
from core_models.status import NOT_CONVERGED, OK, UNSETTLED
from core_models.yield_condition.interface import guess_increment, return_to_surface, search_surface

MAXIMUM_ITERATIONS = 100


class VonMises(NamedTuple):
    """Von Mises yield condition: q = sqrt(3/2 s:s) <= sigma_y, with associated flow.

    The stress measure is that of the update which calls it: Cauchy in the hypoelastic, Kirchhoff in the hyperelastic.
    Source: von Mises (1913); radial return: Wilkins (1964), Simo & Hughes, Computational Inelasticity (1998), box 3.1.
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


@guess_increment.register(VonMises)
def _(
    yield_condition, flow, trial, shear_3, stress_before, plastic_strain, hardening_variable, over_dt, temperature,
):  # fmt: skip
    """One Newton step from the increment that lets the stress stay what it was; 0 in the elastic case."""
    guess = max((trial - stress_before) / shear_3, 0.0)
    residual, slope, _stress, _variable, _variable_slope = _consistency(
        flow, trial, shear_3, plastic_strain, hardening_variable, over_dt, temperature, guess
    )
    return max(guess - residual / slope, 0.0)


@return_to_surface.register(VonMises)
def _(
    yield_condition, flow, guess, trial, shear_3, plastic_strain, hardening_variable, over_dt, temperature, tolerance,
):  # fmt: skip
    """Radial return: q_trial - 3 G dp = sigma_y(ep + dp, dp/dt, T).

    In steady flow one Newton step from the guess does, and it is taken without another look at the flow law because
    its second-order remainder is below the tolerance. A guess of 0 is compared with the flow stress at rate 0, the
    elastic case. What is not so simple is left to `search_surface`.
    """
    residual, slope, stress, variable, variable_slope = _consistency(
        flow, trial, shear_3, plastic_strain, hardening_variable, over_dt, temperature, guess
    )
    is_elastic = guess == 0.0 and residual <= 0.0
    step = 0.0 if is_elastic else -residual / slope
    hardening = -(slope + shear_3) * step
    is_done = abs(hardening * step) <= tolerance * trial * guess and abs(step) < guess
    stress += hardening
    factor = 1.0 if is_elastic else stress / trial
    return (
        factor,
        guess + step,
        stress,
        variable + variable_slope * step,
        OK if is_elastic or is_done else UNSETTLED,
    )


@search_surface.register(VonMises)
def _(
    yield_condition, flow, trial, shear_3, plastic_strain, hardening_variable, over_dt, temperature, tolerance,
):  # fmt: skip
    return _search(flow, trial, shear_3, plastic_strain, hardening_variable, over_dt, temperature, tolerance)


@beside_kernel
def _search(flow, trial, shear_3, plastic_strain, hardening_variable, over_dt, temperature, tolerance):
    """The root by Newton steps, or the elastic case.

    The residual falls with dp, steeply near 0 where the rate dependence is logarithmic. From its positive side Newton
    steps in dp cannot overshoot, from its negative side steps in ln dp cannot; a bracket guards laws that are neither.
    There is no root for q_trial <= sigma_y(ep, 0, T), the elastic case.
    """
    yield_stress = flow_stress(flow, hardening_variable, plastic_strain, 0.0, temperature)[0]
    if trial <= yield_stress:
        return 1.0, 0.0, yield_stress, hardening_variable, OK
    low, high = 0.0, 2.0 * trial / shear_3  # the root is at trial / shear_3 at most
    increment = (trial - yield_stress) / shear_3
    limit = tolerance * trial
    for _iteration in range(MAXIMUM_ITERATIONS):
        residual, slope, stress, variable, variable_slope = _consistency(
            flow, trial, shear_3, plastic_strain, hardening_variable, over_dt, temperature, increment
        )
        if abs(residual) <= limit or high - low <= 1e-15 * high:
            return stress / trial, increment, stress, variable, OK
        step = -residual / slope
        hardening = -(slope + shear_3) * step
        if abs(hardening * step) <= limit * increment and abs(step) < increment:
            stress += hardening
            return stress / trial, increment + step, stress, variable + variable_slope * step, OK
        if residual > 0.0:
            low = increment
            increment += step
        else:
            high = increment
            increment *= math.exp(step / increment)
        if not low < increment < high:
            increment = 0.5 * (low + high)
    return 1.0, 0.0, 0.0, hardening_variable, NOT_CONVERGED

"""The generic functions of yield conditions whose return is radial: a scalar equation."""

from core_models.dispatch import generic
from core_models.status import OK


@generic
def guess_increment(
    yield_condition, flow, trial, shear_3, stress_before, plastic_strain, hardening_variable, over_dt, temperature,
):  # fmt: skip
    """Increment of equivalent plastic strain [-] for `return_to_surface` to begin with, >= 0.

    Parameters
    ----------
    trial, stress_before : equivalent stress of the trial and before the step [Pa].
    shear_3 : three times the shear modulus that the return works against [Pa].
    plastic_strain, hardening_variable, temperature : state before the step. over_dt : 1 / dt [1/s].
    """


@guess_increment.register(type(None))
def _(
    yield_condition, flow, trial, shear_3, stress_before, plastic_strain, hardening_variable, over_dt, temperature,
):  # fmt: skip
    return 0.0


@generic
def return_to_surface(
    yield_condition, flow, guess, trial, shear_3, plastic_strain, hardening_variable, over_dt, temperature, tolerance,
):  # fmt: skip
    """Return an equivalent trial stress to the yield surface, in a straight line of arithmetic as far as that does.

    Parameters
    ----------
    guess : of `guess_increment`, which also says what the others are.
    tolerance : relative, of the consistency condition.

    Returns
    -------
    (factor on the trial deviator, equivalent plastic strain increment, flow stress [Pa], hardening variable, status);
    the status UNSETTLED leaves the point to `search_surface`
    """


@return_to_surface.register(type(None))
def _(
    yield_condition, flow, guess, trial, shear_3, plastic_strain, hardening_variable, over_dt, temperature, tolerance,
):  # fmt: skip
    return 1.0, 0.0, 0.0, hardening_variable, OK


@generic
def search_surface(
    yield_condition, flow, trial, shear_3, plastic_strain, hardening_variable, over_dt, temperature, tolerance,
):  # fmt: skip
    """What `return_to_surface` leaves with the status UNSETTLED, by iterations; the same results."""


@search_surface.register(type(None))
def _(
    yield_condition, flow, trial, shear_3, plastic_strain, hardening_variable, over_dt, temperature, tolerance,
):  # fmt: skip
    return 1.0, 0.0, 0.0, hardening_variable, OK

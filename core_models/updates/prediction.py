"""What the parts of an elastic-plastic step hand to each other: elastic trial and return to the yield surface."""

from typing import NamedTuple

from core_models.compilation import inside_kernel
from core_models.rows import CORRECTION, PREDICTION, get, get_symmetric, put, put_symmetric
from core_models.status import OK
from core_models.updates.conditions import carried_shear, flow_before, melting_before
from core_models.yield_condition.interface import guess_increment, return_to_surface, search_surface

NO_STRESS = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


class Prediction(NamedTuple):
    """Elastic trial of a step.

    trial : deviatoric trial stress (six components) [Pa]. volume_ratio_0, volume_ratio_1 : J before and after.
    stress, stress_before : equivalent stress of the trial and before the step [Pa]. shear_3 : three times the shear
    modulus that the return works against [Pa]. work, along_flow : what the update's `complete` needs for the work.
    """

    trial: tuple
    volume_ratio_0: float
    volume_ratio_1: float
    stress: float
    stress_before: float
    shear_3: float
    work: float
    along_flow: float


class Correction(NamedTuple):
    """Result of the return: factor on the trial deviator, increment of equivalent plastic strain, flow stress [Pa]
    and hardening variable.
    """

    factor: float
    increment: float
    flow_stress: float
    hardening_variable: float


NO_PREDICTION = Prediction(NO_STRESS, 1.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0)


@inside_kernel
def put_prediction(rows, k, prediction):
    """Write the prediction of point k."""
    put_symmetric(rows, PREDICTION, k, prediction.trial)
    put(rows, PREDICTION + 6, k, prediction.volume_ratio_0)
    put(rows, PREDICTION + 7, k, prediction.volume_ratio_1)
    put(rows, PREDICTION + 8, k, prediction.stress)
    put(rows, PREDICTION + 9, k, prediction.stress_before)
    put(rows, PREDICTION + 10, k, prediction.shear_3)
    put(rows, PREDICTION + 11, k, prediction.work)
    put(rows, PREDICTION + 12, k, prediction.along_flow)


@inside_kernel
def get_prediction(rows, k):
    """The prediction of point k."""
    return Prediction(
        get_symmetric(rows, PREDICTION, k),
        get(rows, PREDICTION + 6, k),
        get(rows, PREDICTION + 7, k),
        get(rows, PREDICTION + 8, k),
        get(rows, PREDICTION + 9, k),
        get(rows, PREDICTION + 10, k),
        get(rows, PREDICTION + 11, k),
        get(rows, PREDICTION + 12, k),
    )


@inside_kernel
def put_correction(rows, k, correction):
    """Write the correction of point k."""
    put(rows, CORRECTION, k, correction.factor)
    put(rows, CORRECTION + 1, k, correction.increment)
    put(rows, CORRECTION + 2, k, correction.flow_stress)
    put(rows, CORRECTION + 3, k, correction.hardening_variable)


@inside_kernel
def get_correction(rows, k):
    """The correction of point k."""
    return Correction(
        get(rows, CORRECTION, k),
        get(rows, CORRECTION + 1, k),
        get(rows, CORRECTION + 2, k),
        get(rows, CORRECTION + 3, k),
    )


@inside_kernel
def has_no_strength(material, point, volume_ratio):
    """Whether a point has melted or failed: it then carries no deviatoric stress."""
    return carried_shear(material, point) == 0.0 or point.temperature >= melting_before(
        material, point, volume_ratio
    )


@inside_kernel
def guess(material, prediction, over_dt, point):
    """Plastic increment for `correct` to begin with."""
    flow = flow_before(material, point, prediction.volume_ratio_0)
    return guess_increment(
        material.yield_condition, flow, prediction.stress, prediction.shear_3, prediction.stress_before,
        point.equivalent_plastic_strain, point.hardening_variable, over_dt, point.temperature,
    )  # fmt: skip


@inside_kernel
def correct(material, prediction, guessed, over_dt, point):
    """Return a prediction to the yield surface, or to zero: status and correction; UNSETTLED leaves it to `search`."""
    flow = flow_before(material, point, prediction.volume_ratio_0)
    factor, increment, flow_stress, hardening, status = return_to_surface(
        material.yield_condition, flow, guessed, prediction.stress, prediction.shear_3,
        point.equivalent_plastic_strain, point.hardening_variable, over_dt, point.temperature,
        material.update.tolerance,
    )  # fmt: skip
    if has_no_strength(material, point, prediction.volume_ratio_0):
        factor, increment, flow_stress, hardening, status = 0.0, 0.0, 0.0, point.hardening_variable, OK
    return status, Correction(factor, increment, flow_stress, hardening)


@inside_kernel
def search(material, prediction, over_dt, point):
    """Status and correction of a prediction that `correct` has left."""
    flow = flow_before(material, point, prediction.volume_ratio_0)
    factor, increment, flow_stress, hardening, status = search_surface(
        material.yield_condition, flow, prediction.stress, prediction.shear_3,
        point.equivalent_plastic_strain, point.hardening_variable, over_dt, point.temperature,
        material.update.tolerance,
    )  # fmt: skip
    return status, Correction(factor, increment, flow_stress, hardening)

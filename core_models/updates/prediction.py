"""What the parts of a step hand to each other: elastic trial, return to the yield surface, completion.

The parts run one after the other over a chunk of points. Few numbers then live at a time, and the processor works on
several points at once where a single long function would wait for itself: half the time per point.
"""

from typing import NamedTuple

from core_models.compilation import inside_kernel
from core_models.laws import eroded_stress, melting_temperature, return_to_surface
from core_models.state import read
from core_models.status import OK

NO_STRESS = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
SHEAR = (0.0, 0.0, 0.0, 1.0, 0.0, 0.0)
PREDICTION_SIZE = 13
CORRECTION_SIZE = 4


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
def store_prediction(table, k, prediction):
    """Write a prediction in row k."""
    t = prediction.trial
    table[k, 0], table[k, 1], table[k, 2], table[k, 3], table[k, 4], table[k, 5] = t
    table[k, 6] = prediction.volume_ratio_0
    table[k, 7] = prediction.volume_ratio_1
    table[k, 8] = prediction.stress
    table[k, 9] = prediction.stress_before
    table[k, 10] = prediction.shear_3
    table[k, 11] = prediction.work
    table[k, 12] = prediction.along_flow


@inside_kernel
def load_prediction(table, k):
    """The prediction in row k."""
    return Prediction(
        (table[k, 0], table[k, 1], table[k, 2], table[k, 3], table[k, 4], table[k, 5]),
        table[k, 6], table[k, 7], table[k, 8], table[k, 9], table[k, 10], table[k, 11], table[k, 12],
    )  # fmt: skip


@inside_kernel
def correct(material, table, corrections, k, over_dt, state, i):
    """Return the prediction in row k of a table to the yield surface, or to zero where point i has melted or failed.

    Writes row k of `corrections` and returns a status.
    """
    temperature = read(state.temperature, i, 0.0)
    hardening = read(state.hardening_variable, i, 0.0)
    factor, increment, flow_stress, status = 0.0, 0.0, 0.0, OK
    has_failed = eroded_stress(material.erosion, read(state.damage, i, 0.0), SHEAR, 0.0)[0] != SHEAR
    if temperature < melting_temperature(material.melting) and not has_failed:
        factor, increment, flow_stress, hardening, status = return_to_surface(
            material.yield_condition, material.flow, table[k, 8], table[k, 10], table[k, 9],
            read(state.equivalent_plastic_strain, i, 0.0), hardening, over_dt, temperature,
            material.update.tolerance,
        )  # fmt: skip
    corrections[k, 0], corrections[k, 1] = factor, increment
    corrections[k, 2], corrections[k, 3] = flow_stress, hardening
    return status


@inside_kernel
def load_correction(corrections, k):
    """The correction in row k."""
    return Correction(corrections[k, 0], corrections[k, 1], corrections[k, 2], corrections[k, 3])

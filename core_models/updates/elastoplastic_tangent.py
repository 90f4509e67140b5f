"""Linearisation of an elastic-plastic step: of the radial return, the pressure with its energy, and the stress."""

from core_models.columns import get_point, put_point
from core_models.compilation import inside_kernel
from core_models.dispatch import generic
from core_models.laws import eroded_stress, evolve_hardening, flow_stress, is_out
from core_models.rows import F0, F1, LENGTH, get, get_tensor
from core_models.status import OK
from core_models.tensors import determinant, inverse, mean, plus, plus_isotropic, scaled
from core_models.updates.balance import cold_pressure, complete_point, leave_behind, put_balance
from core_models.updates.conditions import flow_before
from core_models.updates.elastoplastic import correct_rows, predict_rows
from core_models.updates.interface import stress_measure
from core_models.updates.prediction import NO_STRESS, Correction, get_correction, get_prediction
from core_models.updates.tangent import direction, put_change, put_nothing, put_stress


@generic
def kinematics(update, material, f0, f1, point, prediction):
    """What `trial_change` needs and what is the same in all directions of the deformation gradient after the step."""


@generic
def trial_change(update, motion, towards, prediction):
    """Change of a `Prediction` in a `Direction`: a `Prediction` of the derivatives.

    Parameters
    ----------
    motion : of `kinematics`.
    """


@generic
def work_change(update, prediction, correction, prediction_change, correction_change):
    """Change of the work that `complete` (core_models.updates.interface) gives [J/m^3]."""


@generic
def measure_change(update, volume_ratio_change):
    """Change of `stress_measure` (core_models.updates.interface) with J."""


@generic
def hardening_modulus(flow, increment, over_dt, point):
    """Slope of the flow stress by the increment of plastic strain of the step, its rate and history included [Pa]."""


@hardening_modulus.register(type(None))
def _(flow, increment, over_dt, point):
    return 0.0


@hardening_modulus.otherwise
def _(flow, increment, over_dt, point):
    rate = increment * over_dt
    variable, variable_slope, variable_rate = evolve_hardening(
        flow, point.hardening_variable, increment, rate, point.temperature
    )
    _stress, by_variable, by_strain, by_rate, _by_temperature = flow_stress(
        flow, variable, point.equivalent_plastic_strain + increment, rate, point.temperature
    )
    return by_strain + by_rate * over_dt + by_variable * (variable_slope + variable_rate * over_dt)


@inside_kernel
def linearise_elastoplastic(update, rows, statuses, count, model, dt, start, stresses, tangents):
    """What `linearise_rows` (core_models.updates.tangent) does for an elastic-plastic update."""
    predict_rows(rows, statuses, count, model)
    correct_rows(rows, statuses, count, model, 1.0 / dt)
    for k in range(count):
        before, prediction, correction = get_point(rows, k), get_prediction(rows, k), get_correction(rows, k)
        if is_out(model.erosion, before.damage):
            statuses[k] = OK
            leave_behind(rows, k, before)
            put_nothing(stresses, tangents, start + k)
            continue
        after, balance = complete_point(model, None, prediction, correction, dt, get(rows, LENGTH, k), before)
        if statuses[k] == OK:
            flow = flow_before(model, before, prediction.volume_ratio_0)
            modulus = hardening_modulus(flow, correction.increment, 1.0 / dt, before)
            linearise_point(
                model, get_tensor(rows, F0, k), get_tensor(rows, F1, k), before, after, prediction, correction,
                modulus, start + k, stresses, tangents,
            )  # fmt: skip
        put_point(rows, k, after)
        put_balance(rows, k, balance)


@inside_kernel
def linearise_point(model, f0, f1, before, after, prediction, correction, modulus, place, stresses, tangents):
    """Write first Piola stress and tangent of a point, from its states before and after the step and the hardening
    modulus of the step.
    """
    j = prediction.volume_ratio_1
    inverse_f = inverse(f1, determinant(f1))
    tau = scaled(after.stress, j)
    put_stress(stresses, place, tau, inverse_f)
    motion = kinematics(model.update, model, f0, f1, before, prediction)
    mean_stress = mean(after.stress)
    by_volume, by_work = pressure_slopes(model, prediction, before, after, mean_stress)
    measure = stress_measure(model.update, j)
    for number in range(9):
        towards = direction(number, inverse_f, j)
        trial = trial_change(model.update, motion, towards, prediction)
        returned = return_change(prediction, correction, trial, modulus)
        work = work_change(model.update, prediction, correction, trial, returned)
        mean_change = by_volume * towards.volume_ratio + by_work * work
        share = (
            measure_change(model.update, towards.volume_ratio) * correction.factor + measure * returned.factor
        )
        change = plus(scaled(trial.trial, measure * correction.factor), scaled(prediction.trial, share))
        change = plus_isotropic(change, j * mean_change + towards.volume_ratio * mean_stress)
        put_change(tangents, place, number, change, tau, towards, inverse_f)


@inside_kernel
def return_change(prediction, correction, trial, modulus):
    """Change of a `Correction` in a direction in which the prediction changes by `trial`.

    From q - 3G dp = sigma_y(dp): (3G + H) d(dp) = dq - dp d(3G), with the hardening modulus H of the step.
    """
    if correction.increment == 0.0:
        return Correction(0.0, 0.0, 0.0, 0.0)
    increment = (trial.stress - correction.increment * trial.shear_3) / (prediction.shear_3 + modulus)
    flow = modulus * increment
    return Correction((flow - correction.factor * trial.stress) / prediction.stress, increment, flow, 0.0)


@inside_kernel
def pressure_slopes(model, prediction, before, after, mean_stress):
    """Slopes of the mean stress by J [Pa] and by the work of the deviator [-], with the energy that it adds itself.

    p = p(J, e) with e = e_0 + w + (p_0 + p) (J - J_0) / 2, see `advance_pressure` (core_models.updates.balance).
    """
    change = prediction.volume_ratio_1 - prediction.volume_ratio_0
    bare, slope, by_energy = cold_pressure(
        model, prediction.volume_ratio_1, before.temperature, after.internal_energy
    )
    sign = 1.0 if bare > 0.0 else -1.0
    share = sign * eroded_stress(model.erosion, before.damage, NO_STRESS, sign)[1]
    if share == 0.0:
        return 0.0, 0.0
    over = 1.0 / (1.0 - 0.5 * by_energy * change)
    by_volume = slope + 0.5 * by_energy * (mean(before.stress) + mean_stress / share)
    return by_volume * over * share, by_energy * over * share

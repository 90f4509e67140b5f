"""Linearisation of an elastic-plastic step whose return is a local problem."""

from core_models.compilation import inside_kernel
from core_models.dispatch import generic
from core_models.laws import eroded_stress, is_out
from core_models.rotation import asymmetry
from core_models.rows import F0, F1, get_tensor
from core_models.status import OK
from core_models.tensors import (
    THIRD,
    determinant,
    inverse,
    plus,
    plus_isotropic,
    scaled,
    symmetric_inverse,
    symmetric_part,
    transposed_product,
)
from core_models.updates.balance import leave_behind
from core_models.updates.conditions import flow_before
from core_models.updates.corotation import forth
from core_models.updates.elastoplastic_tangent import kinematics, measure_change, trial_change
from core_models.updates.general import General, complete_step, solved_step
from core_models.updates.general_problem import return_change
from core_models.updates.hyperelastic_plastic import HyperelasticPlastic
from core_models.updates.hypoelastic_plastic import HypoelasticPlastic
from core_models.updates.hypoelastic_tangent import strain_change
from core_models.updates.interface import stress_measure
from core_models.updates.prediction import NO_STRESS, has_no_strength
from core_models.updates.tangent import direction, linearise_rows, put_change, put_nothing, put_stress
from core_models.updates.turning import polar
from core_models.yield_condition import drucker_prager_change, mohr_coulomb_change  # noqa: F401


@linearise_rows.register(General)
def _(update, rows, statuses, count, model, dt, start, stresses, tangents):
    for k in range(count):
        statuses[k], step = solved_step(update, rows, k, model, 1.0 / dt)
        if is_out(model.erosion, step.before.damage):
            statuses[k] = OK
            leave_behind(rows, k, step.before)
            put_nothing(stresses, tangents, start + k)
            continue
        if statuses[k] == OK:
            flow = flow_before(model, step.before, step.prediction.volume_ratio_0)
            law = model.yield_condition
            linearise_point(update, rows, k, model, law, flow, step, start + k, stresses, tangents)
        complete_step(update, rows, k, model, None, dt, step)


@inside_kernel
def linearise_point(update, rows, k, model, yield_condition, flow, step, place, stresses, tangents):
    """Write first Piola stress and tangent of a point whose step has been solved with a yield condition and a flow
    law.
    """
    before, prediction, problem, returned = step.before, step.prediction, step.problem, step.returned
    f0, f1 = get_tensor(rows, F0, k), get_tensor(rows, F1, k)
    j = prediction.volume_ratio_1
    measure = stress_measure(update.kinematics, j)
    to_cauchy = measure / j
    mean_stress = returned.mean_stress * to_cauchy
    kept = eroded_stress(model.erosion, before.damage, NO_STRESS, mean_stress)[1]
    stress = plus_isotropic(returned.deviator, kept / to_cauchy)
    inverse_f = inverse(f1, determinant(f1))
    tau = scaled(stress, measure)
    put_stress(stresses, place, tau, inverse_f)
    motion = kinematics(update.kinematics, model, f0, f1, before, prediction)
    is_weak = has_no_strength(model, before, prediction.volume_ratio_0)
    for number in range(9):
        towards = direction(number, inverse_f, j)
        trial = trial_change(update.kinematics, motion, towards, prediction)
        growth = measure_change(update.kinematics, towards.volume_ratio)
        volume = towards.volume_ratio / j
        mean_trial = returned.bulk * volume + returned.mean_stress * (volume - growth / measure)
        spin = spin_change(model.kinematic_hardening, update.kinematics, motion, f1, towards)
        deviator, mean_change = return_change(
            yield_condition, model, flow, problem, returned, rows, k, trial.trial, trial.shear_3 * THIRD,
            mean_trial, spin,
        )  # fmt: skip
        if is_weak:
            deviator, mean_change = NO_STRESS, mean_trial
        change = plus_isotropic(deviator, mean_change if kept == mean_stress else 0.0)
        put_change(
            tangents,
            place,
            number,
            plus(scaled(change, measure), scaled(stress, growth)),
            tau,
            towards,
            inverse_f,
        )


@generic
def spin_change(kinematic_hardening, update, motion, f, towards):
    """Axial vector of the spin, in a direction, of the frame in which back stresses stay, if there are any."""


@spin_change.register(type(None))
def _(kinematic_hardening, update, motion, f, towards):
    return (0.0, 0.0, 0.0)


@spin_change.otherwise
def _(kinematic_hardening, update, motion, f, towards):
    return frame_spin(update, motion, f, towards)


@generic
def frame_spin(update, motion, f, towards):
    """Axial vector of dR R^T, R the rotation of the update's frame."""


@frame_spin.register(HypoelasticPlastic)
def _(update, motion, f, towards):
    return forth(motion.motion.whole, strain_change(motion.motion, towards)[1])


@frame_spin.register(HyperelasticPlastic)
def _(update, motion, f, towards):
    """With F = R U and R^T dR = [w]: (tr U 1 - U) w = axial(R^T dF - dF^T R)."""
    r = polar(f)
    u = symmetric_part(transposed_product(r, f))
    x, y, z = asymmetry(transposed_product(r, towards.gradient))
    g = symmetric_inverse((u[1] + u[2], u[0] + u[2], u[0] + u[1], -u[3], -u[4], -u[5]))
    w = (
        g[0] * x + g[3] * y + g[5] * z,
        g[3] * x + g[1] * y + g[4] * z,
        g[5] * x + g[4] * y + g[2] * z,
    )
    return forth(r, w)

"""Linearisation of the hypoelastic-plastic step with an anisotropic stiffness."""

from core_models.compilation import inside_kernel
from core_models.elasticity.stiffness import stressed
from core_models.laws import elastic_moduli, is_out
from core_models.rows import F0, F1, get_tensor
from core_models.status import OK
from core_models.tensors import (
    congruence,
    deviator,
    inverse,
    mean,
    plus,
    plus_isotropic,
    product,
    scaled,
    trace,
    transposed,
)
from core_models.updates.anisotropic_plastic import AnisotropicPlastic, carried, complete_step, solved_step
from core_models.updates.anisotropic_return import anisotropic_change
from core_models.updates.balance import leave_behind
from core_models.updates.conditions import flow_before
from core_models.updates.corotation import forth
from core_models.updates.hypoelastic_tangent import strain_change, unrotated_motion
from core_models.updates.prediction import NO_STRESS, has_no_strength
from core_models.updates.tangent import (
    direction,
    linearise_rows,
    put_change,
    put_nothing,
    put_stress,
    transported,
)


@linearise_rows.register(AnisotropicPlastic)
def _(update, rows, statuses, count, model, dt, start, stresses, tangents):
    for k in range(count):
        statuses[k], step = solved_step(update, rows, k, model, 1.0 / dt)
        if is_out(model.erosion, step.before.damage):
            statuses[k] = OK
            leave_behind(rows, k, step.before)
            put_nothing(stresses, tangents, start + k)
            continue
        if statuses[k] == OK:
            flow = flow_before(model, step.before, step.volume_ratio_0)
            linearise_point(update, rows, k, model, flow, step, start + k, stresses, tangents)
        complete_step(rows, k, model, None, dt, step)


@inside_kernel
def linearise_point(update, rows, k, model, flow, step, place, stresses, tangents):
    """Write first Piola stress and tangent of a point whose step has been solved with a flow law.

    In the axes of the material all comes from the change of the strain increment; the axes turn with R.
    """
    before, problem, returned = step.before, step.problem, step.returned
    f0, f1 = get_tensor(rows, F0, k), get_tensor(rows, F1, k)
    j = step.volume_ratio_1
    stress, mean_stress = carried(model, before, returned)
    cauchy = congruence(problem.axes, stress)
    inverse_f = inverse(f1, j)
    tau = scaled(cauchy, j)
    put_stress(stresses, place, tau, inverse_f)
    motion = unrotated_motion(None, f0, f1, before.rotation)
    back = transposed(product(motion.rotation_before, problem.elastic.axes))
    is_weak = has_no_strength(model, before, step.volume_ratio_0)
    bulk = elastic_moduli(model.elasticity)[0]
    share = mean_stress / mean(returned.stress) if mean(returned.stress) != 0.0 else 1.0
    for number in range(9):
        towards = direction(number, inverse_f, j)
        rate, spin = strain_change(motion, towards)
        strain = congruence(back, rate)
        if is_weak:
            change = plus_isotropic(NO_STRESS, bulk * trace(strain))
        else:
            trial = stressed(problem.elastic, strain)
            change = anisotropic_change(model.yield_condition, model, flow, problem, returned, rows, k, trial)
        change = plus_isotropic(deviator(change), share * mean(change))
        change = plus(congruence(problem.axes, change), transported(spinning(motion.increment, spin), cauchy))
        change = plus(scaled(change, j), scaled(cauchy, towards.volume_ratio))
        put_change(tangents, place, number, change, tau, towards, inverse_f)


@inside_kernel
def spinning(increment, spin):
    """The tensor dR R^T of dQ = Q [spin], R_1 = Q R_0."""
    x, y, z = forth(increment, spin)
    return (0.0, -z, y, z, 0.0, -x, -y, x, 0.0)

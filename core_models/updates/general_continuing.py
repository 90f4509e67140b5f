"""The tangent of continued flow of points whose return is a local problem.

It is that of the return to a surface which lies a millionth of its size below the stress and hardens as the flow goes
on, at constant rate.
"""

from core_models.columns import get_point
from core_models.compilation import beside_kernel, inside_kernel
from core_models.flow.linear import LinearHardening
from core_models.laws import predict_carefully, stress_measure
from core_models.rows import BACK_STRESS, F0, ROTATION_1, get_symmetric, get_tensor, put_symmetric, put_vector
from core_models.tensors import contract, minus
from core_models.updates.conditions import flow_before
from core_models.updates.continued_flow import YIELDING, continue_point, continued_hardening, warming
from core_models.updates.general import General, Step, posed
from core_models.updates.general_problem import ELASTIC, mean_stress, return_stress, strength, unchanged
from core_models.updates.general_tangent import linearise_point
from core_models.updates.prediction import NO_STRESS, has_no_strength

OVERSHOOT = 1e-6  # of the flow stress
LOWEST = 1e-12  # of the shear modulus: flow stress that counts as none
FIRST_STRIDE, STRIDES, BISECTIONS = 4e-6, 30, 60
PRECISION = 1e-11


@continue_point.register(General)
def _(update, model, rows, k, place, stresses, tangents):
    f, before = get_tensor(rows, F0, k), get_point(rows, k)
    _status, prediction, rotation = predict_carefully(update.kinematics, model, f, f, before)
    put_vector(rows, ROTATION_1, k, rotation)
    j = prediction.volume_ratio_1
    problem = posed(update, rows, k, model, prediction, 0.0, before)
    flow = flow_before(model, before, j)
    stress, bulk = mean_stress(model.eos, problem, problem.volume)
    returned = unchanged(problem, stress, bulk)
    level = LOWEST * problem.shear
    if not has_no_strength(model, before, j):
        level = _level(model, problem, rows, k, max(YIELDING * strength(flow, problem, 0.0).stress, level))
    start, modulus = level, 0.0
    if level > LOWEST * problem.shear:
        start = (1.0 - OVERSHOOT) * level
        slightly = _returned(model, LinearHardening(start, 0.0), problem, rows, k)
        heat = warming(model, before, stress_measure(update.kinematics, j))
        share = _work(problem, slightly) / (level * slightly.increment) if slightly.increment > 0.0 else 0.0
        is_flowing, modulus = continued_hardening(flow, level, before, heat * share)
        start -= modulus * before.equivalent_plastic_strain
        if is_flowing:
            returned = return_stress(
                model.yield_condition, model, LinearHardening(start, modulus), problem, rows, k
            )
    step = Step(before, prediction, problem, returned, NO_STRESS)
    linearise_point(update, rows, k, model, LinearHardening(start, modulus), step, place, stresses, tangents)


@beside_kernel
def _level(model, problem, rows, k, lowest):
    """Flow stress on whose surface the point lies [Pa], by bisection; 0 where that is below `lowest`."""
    low, high, stride = lowest, lowest, FIRST_STRIDE
    for _stride in range(STRIDES):
        if _returned(model, LinearHardening(high, 0.0), problem, rows, k).regime == ELASTIC:
            break
        low, high, stride = high, (1.0 + stride) * high, 4.0 * stride
    if high == lowest:
        return 0.0
    for _bisection in range(BISECTIONS):
        if high - low <= PRECISION * high:
            break
        middle = 0.5 * (low + high)
        if _returned(model, LinearHardening(middle, 0.0), problem, rows, k).regime == ELASTIC:
            high = middle
        else:
            low = middle
    return low


@beside_kernel
def _returned(model, flow, problem, rows, k):
    """The return with a flow law, which leaves the back stresses of the point alone."""
    first, second = get_symmetric(rows, BACK_STRESS, k), get_symmetric(rows, BACK_STRESS + 6, k)
    third, fourth = get_symmetric(rows, BACK_STRESS + 12, k), get_symmetric(rows, BACK_STRESS + 18, k)
    returned = return_stress(model.yield_condition, model, flow, problem, rows, k)
    put_symmetric(rows, BACK_STRESS, k, first)
    put_symmetric(rows, BACK_STRESS + 6, k, second)
    put_symmetric(rows, BACK_STRESS + 12, k, third)
    put_symmetric(rows, BACK_STRESS + 18, k, fourth)
    return returned


@inside_kernel
def _work(problem, returned):
    """Plastic work of a return, net of what is stored [J/m^3]."""
    lost = minus(problem.trial, returned.deviator)
    work = 0.5 / problem.shear * contract(lost, returned.deviator)
    return work + returned.mean_stress * (problem.volume - returned.volume) - returned.stored

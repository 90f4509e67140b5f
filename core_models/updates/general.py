"""Elastic-plastic step of points whose laws need more than the scalar radial return.

Kinematics and elastic trial are those of the hypoelastic- and the hyperelastic-plastic update; the return is a local
problem of its own for each yield condition (core_models.updates.general_problem). Where plastic flow changes the
volume, the equation of state gives the mean Cauchy stress of the elastic part of it, J_e = J / J_p. It is evaluated at
the energy before the step, as the other laws are at the temperature before it.
"""

import math
from typing import NamedTuple

from core_models.bulk_viscosity import viscous_pressure
from core_models.columns import get_point, put_point
from core_models.compilation import inside_kernel
from core_models.dispatch import generic
from core_models.elementary import exponential, logarithm
from core_models.laws import (
    damage_of_porosity,
    elastic_moduli,
    eroded_stress,
    is_out,
    pressure,
    thermal_volume,
)
from core_models.rows import (
    F0,
    F1,
    LENGTH,
    PLASTIC_VOLUME,
    POROSITY,
    ROTATION_1,
    get,
    get_tensor,
    put,
    put_vector,
)
from core_models.state import PointState
from core_models.status import OK
from core_models.tensors import (
    THIRD,
    congruence,
    contract,
    deviator,
    equivalent_stress,
    mean,
    minus,
    plus_isotropic,
    scaled,
)
from core_models.updates.back_stress import turn_back_stresses
from core_models.updates.balance import FOUR_THIRDS, Balance, damaged, heated, leave_behind, put_balance
from core_models.updates.conditions import flow_before, shear_before
from core_models.updates.general_problem import (
    ELASTIC,
    LocalProblem,
    Returned,
    mean_stress,
    return_stress,
    unchanged,
    without_deviator,
)
from core_models.updates.hyperelastic_plastic import HyperelasticPlastic, unimodular_mean
from core_models.updates.hypoelastic_plastic import HypoelasticPlastic
from core_models.updates.interface import advance_rows, predict_carefully, stress_measure
from core_models.updates.prediction import NO_STRESS, Prediction, has_no_strength, put_prediction
from core_models.updates.turning import step_rotation
from core_models.yield_condition import (  # noqa: F401
    drucker_prager_return,
    mohr_coulomb_return,
    von_mises_moving,
)


class General(NamedTuple):
    """A stress update whose return is a local problem; compiled code sees it in the update's place.

    Parameters
    ----------
    kinematics : HypoelasticPlastic or HyperelasticPlastic. tolerance : that of its return.
    """

    kinematics: HypoelasticPlastic | HyperelasticPlastic
    tolerance: float

    is_internal = True


class Step(NamedTuple):
    """A point's step: state before, trial, local problem and its result, deviator before the step as it is turned."""

    before: PointState
    prediction: Prediction
    problem: LocalProblem
    returned: Returned
    turned: tuple


@generic
def isochoric_elastic(update, deviator, shear, trial_mean, is_elastic, before):
    """Isochoric elastic left Cauchy-Green tensor after the step, as far as the update has one."""


@isochoric_elastic.register(HypoelasticPlastic)
def _(update, deviator, shear, trial_mean, is_elastic, before):
    return before


@isochoric_elastic.register(HyperelasticPlastic)
def _(update, deviator, shear, trial_mean, is_elastic, before):
    elastic = scaled(deviator, 1.0 / shear)
    return plus_isotropic(elastic, trial_mean if is_elastic else unimodular_mean(elastic))


@generic
def work_measure(update, volume_ratio_0, volume_ratio_1):
    """Reference volumes per unit of volume of the update's stress measure, in the middle of the step."""


@work_measure.register(HypoelasticPlastic)
def _(update, volume_ratio_0, volume_ratio_1):
    return 0.5 * (volume_ratio_0 + volume_ratio_1)


@work_measure.register(HyperelasticPlastic)
def _(update, volume_ratio_0, volume_ratio_1):
    return 1.0


@generic
def trial_work(update, prediction):
    """Work of the deviatoric trial stress in the step, per unit of volume of the measure [J/m^3]."""


@trial_work.register(HypoelasticPlastic)
def _(update, prediction):
    return 0.5 * (prediction.work + prediction.along_flow)


@trial_work.register(HyperelasticPlastic)
def _(update, prediction):
    return prediction.work


@advance_rows.register(General)
def _(update, rows, statuses, count, model, viscosity, dt):
    for k in range(count):
        statuses[k], step = solved_step(update, rows, k, model, 1.0 / dt)
        if is_out(model.erosion, step.before.damage):
            statuses[k] = OK
            leave_behind(rows, k, step.before)
        else:
            complete_step(update, rows, k, model, viscosity, dt, step)


@inside_kernel
def solved_step(update, rows, k, model, over_dt):
    """Elastic trial and return of the point: status and `Step`; the rotation after the step goes to its row."""
    before = get_point(rows, k)
    f0, f1 = get_tensor(rows, F0, k), get_tensor(rows, F1, k)
    status, prediction, rotation = predict_carefully(update.kinematics, model, f0, f1, before)
    put_prediction(rows, k, prediction)
    put_vector(rows, ROTATION_1, k, rotation)
    turned = NO_STRESS
    if status == OK:
        turn = step_rotation(update.kinematics, model.objective_rate, f0, f1, before.rotation, rotation)
        j0 = prediction.volume_ratio_0
        measured = j0 / stress_measure(update.kinematics, j0)
        turned = congruence(turn, scaled(deviator(before.stress), measured))
        turn_back_stresses(model.kinematic_hardening, turn, rows, k)
    problem = posed(update, rows, k, model, prediction, over_dt, before)
    flow = flow_before(model, before, prediction.volume_ratio_0)
    stress, bulk = mean_stress(model.eos, problem, problem.volume)
    returned = unchanged(problem, stress, bulk)
    if has_no_strength(model, before, prediction.volume_ratio_0):
        returned = without_deviator(returned)
    elif status == OK:
        returned = return_stress(model.yield_condition, model, flow, problem, rows, k)
        status = returned.status
    return status, Step(before, prediction, problem, returned, turned)


@inside_kernel
def posed(update, rows, k, model, prediction, over_dt, before):
    """The local problem of a point."""
    j = prediction.volume_ratio_1
    return LocalProblem(
        prediction.trial,
        logarithm(j / thermal_volume(model.expansion, before.temperature)) - get(rows, PLASTIC_VOLUME, k),
        prediction.shear_3 * THIRD,
        j / stress_measure(update.kinematics, j),
        before.internal_energy,
        before.equivalent_plastic_strain,
        before.hardening_variable,
        before.temperature,
        get(rows, POROSITY, k),
        over_dt,
        update.tolerance,
    )


@inside_kernel
def complete_step(update, rows, k, model, viscosity, dt, step):
    """Write state and balance of a point after its step."""
    prediction, problem, returned, before = step.prediction, step.problem, step.returned, step.before
    j0, j1 = prediction.volume_ratio_0, prediction.volume_ratio_1
    measure = stress_measure(update.kinematics, j1)
    to_cauchy = measure / j1
    mean_stress = eroded_stress(model.erosion, before.damage, NO_STRESS, returned.mean_stress * to_cauchy)[1]
    lost = minus(problem.trial, returned.deviator)
    over_shear = 0.5 / problem.shear
    work = trial_work(update.kinematics, prediction) - 0.5 * over_shear * contract(
        lost, minus(problem.trial, step.turned)
    )
    work *= work_measure(update.kinematics, j0, j1)
    work += 0.5 * (mean(before.stress) + mean_stress) * (j1 - j0)
    dissipation = 0.0
    if returned.regime != ELASTIC:
        dissipation = over_shear * contract(lost, returned.deviator)
        dissipation += returned.mean_stress * (problem.volume - returned.volume) - returned.stored
    dissipation *= measure
    shear = shear_before(model, before, j0)
    stiff = max(
        shear, elastic_moduli(model.elasticity)[1]
    )  # the stable steps of the solvers know the card's modulus
    speed = wave_speed(model, j1, returned, to_cauchy, stiff, before.internal_energy)
    q = viscous_pressure(
        viscosity, model.density / j1, get(rows, LENGTH, k), speed, 2.0 * (j1 - j0) / (dt * (j0 + j1))
    )
    viscous_work = -q * (j1 - j0)
    put(rows, PLASTIC_VOLUME, k, get(rows, PLASTIC_VOLUME, k) + problem.volume - returned.volume)
    put(rows, POROSITY, k, returned.porosity)
    stress = scaled(returned.deviator, to_cauchy)
    after = PointState(
        plus_isotropic(stress, mean_stress),
        before.rotation,
        isochoric_elastic(
            update.kinematics, returned.deviator, shear, problem.shear / shear, returned.regime == ELASTIC,
            before.elastic_left_cauchy_green,
        ),
        before.equivalent_plastic_strain + returned.increment,
        returned.hardening_variable,
        heated(model, before.temperature, dissipation, j0, j1),
        damage_of_porosity(
            model.yield_condition, returned.porosity,
            damaged(model, before, returned.increment, dt, mean_stress, equivalent_stress(stress)),
        ),
        before.internal_energy + work + viscous_work,
    )  # fmt: skip
    put_point(rows, k, after)
    put_balance(rows, k, Balance(speed, q, work, dissipation, viscous_work))


@inside_kernel
def wave_speed(model, volume_ratio, returned, to_cauchy, shear, energy):
    """Speed of longitudinal waves [m/s], of the elastic volume at constant entropy."""
    cold, slope, by_energy = pressure(model.eos, exponential(returned.volume), energy)
    modulus = max(exponential(returned.volume) * (slope + by_energy * cold), 0.0)
    return math.sqrt((modulus + FOUR_THIRDS * shear * to_cauchy) * volume_ratio / model.density)

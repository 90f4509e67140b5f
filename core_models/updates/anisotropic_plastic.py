"""Hypoelastic-plastic step of points whose elasticity is anisotropic."""

import math
from typing import NamedTuple

from core_models.bulk_viscosity import viscous_pressure
from core_models.columns import get_point, put_point
from core_models.compilation import inside_kernel
from core_models.elasticity.stiffness import largest_modulus, stressed
from core_models.laws import elastic_moduli, eroded_stress, is_out, stiffness
from core_models.quaternions import rotation_matrix, rotation_vector, turned
from core_models.rotation import rotation_increment
from core_models.rows import F0, F1, LENGTH, ROTATION_1, get, get_tensor, put_vector
from core_models.state import PointState
from core_models.status import INVERTED, OK
from core_models.tensors import (
    IDENTITY,
    congruence,
    contract,
    determinant,
    deviator,
    equivalent_stress,
    mean,
    plus,
    plus_isotropic,
    product,
    trace,
    transposed,
)
from core_models.updates.anisotropic_return import (
    AnisotropicProblem,
    AnisotropicReturn,
    anisotropic_return,
    without_flow,
)
from core_models.updates.back_stress import turn_back_stresses
from core_models.updates.balance import Balance, damaged, heated, leave_behind, put_balance
from core_models.updates.conditions import flow_before
from core_models.updates.corotation import stretching
from core_models.updates.hypoelastic_plastic import HypoelasticPlastic, unrotated
from core_models.updates.interface import advance_rows
from core_models.updates.prediction import NO_STRESS, has_no_strength


class AnisotropicPlastic(NamedTuple):
    """The hypoelastic update with an anisotropic stiffness; compiled code sees it in that update's place.

        s_trial = s_n + C : d,   both in the axes of the material, which turn with R of F = V R

    d is the unrotated rate of deformation at mid-step of `HypoelasticPlastic`. C gives the mean stress as well, so that
    there is no equation of state.

    Parameters
    ----------
    kinematics : HypoelasticPlastic. tolerance : that of its return.
    Source: Belytschko, Liu & Moran, Nonlinear Finite Elements (2000), sections 5.4.3 and 5.10 (corotational stress).
    """

    kinematics: HypoelasticPlastic
    tolerance: float

    is_internal = True


class AnisotropicStep(NamedTuple):
    """A point's step: state before, J before and after, rotation R after, strain increment and stress before in the
    axes of the material, local problem and its result.
    """

    before: PointState
    volume_ratio_0: float
    volume_ratio_1: float
    rotation: tuple
    strain: tuple
    stress: tuple
    problem: AnisotropicProblem
    returned: AnisotropicReturn


@advance_rows.register(AnisotropicPlastic)
def _(update, rows, statuses, count, model, viscosity, dt):
    for k in range(count):
        statuses[k], step = solved_step(update, rows, k, model, 1.0 / dt)
        if is_out(model.erosion, step.before.damage):
            statuses[k] = OK
            leave_behind(rows, k, step.before)
        else:
            complete_step(rows, k, model, viscosity, dt, step)


@inside_kernel
def solved_step(update, rows, k, model, over_dt):
    """Elastic trial and return of the point: status and `AnisotropicStep`; the rotation goes to its row."""
    before = get_point(rows, k)
    f0, f1 = get_tensor(rows, F0, k), get_tensor(rows, F1, k)
    j0, j1 = determinant(f0), determinant(f1)
    is_inverted = not min(j0, j1) > 0.0
    if is_inverted:
        f0, f1, j0, j1 = IDENTITY, IDENTITY, 1.0, 1.0
    r0, v0, a = unrotated(f0, f1, before.rotation)
    q, u = rotation_increment(a)
    r1 = turned(q, r0)
    put_vector(rows, ROTATION_1, k, rotation_vector(r1))
    turn_back_stresses(model.kinematic_hardening, rotation_matrix(q), rows, k)
    elastic = stiffness(model.elasticity)
    back = transposed(product(rotation_matrix(r0), elastic.axes))
    strain, stress = congruence(back, stretching(v0, u)), congruence(back, before.stress)
    is_weak = has_no_strength(model, before, j0)
    trial = plus(stress, stressed(elastic, strain))
    if is_weak:
        pressure = mean(stress) + elastic_moduli(model.elasticity)[0] * trace(strain)
        trial = plus_isotropic(NO_STRESS, pressure)
    rotation = rotation_matrix(r1)
    problem = AnisotropicProblem(
        trial,
        elastic,
        product(rotation, elastic.axes),
        elastic_moduli(model.elasticity)[1],
        before.equivalent_plastic_strain,
        before.hardening_variable,
        before.temperature,
        over_dt,
        update.tolerance,
    )
    returned = without_flow(problem)
    if not is_weak:
        flow = flow_before(model, before, j0)
        returned = anisotropic_return(model.yield_condition, model, flow, problem, rows, k)
    status = INVERTED if is_inverted else returned.status
    return status, AnisotropicStep(before, j0, j1, rotation, strain, stress, problem, returned)


@inside_kernel
def complete_step(rows, k, model, viscosity, dt, step):
    """Write state and balance of a point after its step."""
    before, problem, returned = step.before, step.problem, step.returned
    j0, j1 = step.volume_ratio_0, step.volume_ratio_1
    stress, mean_stress = carried(model, before, returned)
    work = 0.25 * (j0 + j1) * (contract(step.stress, step.strain) + contract(stress, step.strain))
    dissipation = 1.5 * returned.increment * contract(returned.stress, returned.direction) - returned.stored
    dissipation *= j1
    speed = math.sqrt(largest_modulus(problem.elastic) * j1 / model.density)
    q = viscous_pressure(
        viscosity, model.density / j1, get(rows, LENGTH, k), speed, 2.0 * (j1 - j0) / (dt * (j0 + j1))
    )
    viscous_work = -q * (j1 - j0)
    after = PointState(
        congruence(problem.axes, stress),
        before.rotation,
        before.elastic_left_cauchy_green,
        before.equivalent_plastic_strain + returned.increment,
        returned.hardening_variable,
        heated(model, before.temperature, dissipation, j0, j1),
        damaged(model, before, returned.increment, dt, mean_stress, equivalent_stress(deviator(stress))),
        before.internal_energy + work + viscous_work,
    )
    put_point(rows, k, after)
    put_balance(rows, k, Balance(speed, q, work, dissipation, viscous_work))


@inside_kernel
def carried(model, before, returned):
    """Stress that erosion leaves a point, in the axes of the material, and its mean [Pa]."""
    mean_stress = eroded_stress(model.erosion, before.damage, NO_STRESS, mean(returned.stress))[1]
    return plus_isotropic(deviator(returned.stress), mean_stress), mean_stress

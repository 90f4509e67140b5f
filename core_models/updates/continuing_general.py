"""Tangent of continued flow where the return is a local problem.

The flow law is replaced by its tangent at the point's own rate, and the surface drawn in a little, so that the point
lies outside: the return then tells on which part of the surface it flows, and its linearisation is the tangent.
"""

import math

from core_models.compilation import beside_kernel, inside_kernel
from core_models.dispatch import generic
from core_models.flow.continued import ContinuedFlow
from core_models.laws import elastic_moduli, heat_capacity, heated_fraction, stiffness
from core_models.principal_axes import principal
from core_models.quaternions import quaternion, rotation_matrix
from core_models.rows import F0, get_tensor
from core_models.tensors import (
    congruence,
    contract,
    determinant,
    deviator,
    equivalent_stress,
    mean,
    minus,
    product,
    transposed,
)
from core_models.updates.anisotropic_plastic import AnisotropicPlastic, AnisotropicStep
from core_models.updates.anisotropic_return import AnisotropicProblem, anisotropic_return, without_flow
from core_models.updates.anisotropic_tangent import linearise_point as linearise_anisotropic
from core_models.updates.back_stress import recovered
from core_models.updates.conditions import flow_before
from core_models.updates.continuing_tangent import continue_point, continued_hardening
from core_models.updates.general import General, Step, posed
from core_models.updates.general_problem import ELASTIC, mean_stress, return_stress, unchanged
from core_models.updates.general_tangent import linearise_point
from core_models.updates.interface import predict_carefully, stress_measure
from core_models.updates.prediction import NO_STRESS, has_no_strength
from core_models.yield_condition.drucker_prager import DruckerPrager
from core_models.yield_condition.gurson import Gurson
from core_models.yield_condition.gurson_surface import yield_function
from core_models.yield_condition.mohr_coulomb import MohrCoulomb
from core_models.yield_condition.mohr_coulomb_planes import DEGREE
from core_models.yield_condition.von_mises import VonMises

DRAWN_IN = 1e-8  # by which part the surface is smaller than that on which a point lies
PRECISION = 1e-13  # of the return to it
BISECTIONS = 80


@generic
def carried_flow_stress(yield_condition, xi, stress, porosity):
    """The flow stress with which a point is on the yield surface [Pa].

    Parameters
    ----------
    xi : deviator beyond the back stress, stress : mean stress [Pa]. porosity : [-].
    """


@carried_flow_stress.register(type(None))
def _(yield_condition, xi, stress, porosity):
    return 0.0


@carried_flow_stress.register(VonMises)
def _(yield_condition, xi, stress, porosity):
    return equivalent_stress(xi)


@carried_flow_stress.register(DruckerPrager)
def _(yield_condition, xi, stress, porosity):
    size = equivalent_stress(xi) / math.sqrt(3.0)
    return max(size + 3.0 * yield_condition.alpha * stress, 0.0) / yield_condition.cohesion_factor


@carried_flow_stress.register(MohrCoulomb)
def _(yield_condition, xi, stress, porosity):
    values, _axes = principal(xi)
    angle = yield_condition.friction_angle * DEGREE
    sheared = values[0] - values[2] + (values[0] + values[2] + 2.0 * stress) * math.sin(angle)
    return max(0.5 * sheared / math.cos(angle), 0.0)


@carried_flow_stress.register(Gurson)
def _(yield_condition, xi, stress, porosity):
    return _porous_flow_stress(yield_condition, equivalent_stress(xi), stress, porosity)


@beside_kernel
def _porous_flow_stress(law, mises, stress, porosity):
    """By bisection: the yield function falls with the flow stress."""
    low, high = 0.0, mises + abs(stress)
    if high == 0.0:
        return 0.0
    while yield_function(law, mises, stress, high, porosity) > 0.0 and high < 1e30:
        low, high = high, 2.0 * high
    for _bisection in range(BISECTIONS):
        middle = 0.5 * (low + high)
        if yield_function(law, mises, stress, middle, porosity) > 0.0:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)


@generic
def drawn_in(yield_condition):
    """The yield condition with cut-offs a little lower."""


@drawn_in.otherwise
def _(yield_condition):
    return yield_condition


@drawn_in.register(DruckerPrager)
def _(yield_condition):
    law = yield_condition
    return DruckerPrager(law.alpha, law.beta, law.cohesion_factor, law.tension_cutoff * (1.0 - DRAWN_IN))


@drawn_in.register(MohrCoulomb)
def _(yield_condition):
    law = yield_condition
    return MohrCoulomb(law.friction_angle, law.dilation_angle, law.tension_cutoff * (1.0 - DRAWN_IN))


@inside_kernel
def warming(model, update, point, volume_ratio):
    """Rise of the temperature with plastic work in the update's measure [K m^3/J]."""
    capacity = model.density * heat_capacity(model.specific_heat, point.temperature)
    return heated_fraction(model.heating) * stress_measure(update, volume_ratio) / capacity


@inside_kernel
def _continued(flow, carried, point, heat, shear):
    """The flow law to go on with: its tangent if the point flows, else a strength of the order of the shear modulus."""
    is_flowing, slope = continued_hardening(flow, carried, point, heat)
    stress = carried * (1.0 - DRAWN_IN) if is_flowing else carried + shear
    return ContinuedFlow(stress, slope if is_flowing else 0.0, point.equivalent_plastic_strain)


@continue_point.register(General)
def _(update, rows, k, model, point, place, stresses, tangents):
    f = get_tensor(rows, F0, k)
    kinematics = update.kinematics
    _status, prediction, _rotation = predict_carefully(kinematics, model, f, f, point)
    j = prediction.volume_ratio_1
    precise = General(kinematics, PRECISION)
    problem = posed(precise, rows, k, model, prediction, 0.0, point)
    stress, bulk = mean_stress(model.eos, problem, problem.volume)
    law, flow = drawn_in(model.yield_condition), flow_before(model, point, j)
    xi = minus(problem.trial, recovered(model.kinematic_hardening, 0.0, rows, k)[0])
    carried = carried_flow_stress(law, xi, stress, problem.porosity)
    heat = warming(model, kinematics, point, j)
    returned = unchanged(problem, stress, bulk)
    continued = _continued(flow, carried, point, 0.0, problem.shear)
    if not has_no_strength(model, point, j):
        returned = return_stress(law, model, continued, problem, rows, k)
        if returned.regime != ELASTIC and heat > 0.0 and returned.increment * carried > 0.0:
            lost = minus(problem.trial, returned.deviator)
            work = 0.5 / problem.shear * contract(lost, returned.deviator)
            work += returned.mean_stress * (problem.volume - returned.volume) - returned.stored
            share = work / (returned.increment * carried)
            continued = _continued(flow, carried, point, heat * share, problem.shear)
            returned = return_stress(law, model, continued, problem, rows, k)
    step = Step(point, prediction, problem, returned, NO_STRESS)
    linearise_point(update, rows, k, model, law, continued, step, place, stresses, tangents)


@continue_point.register(AnisotropicPlastic)
def _(update, rows, k, model, point, place, stresses, tangents):
    f = get_tensor(rows, F0, k)
    j = determinant(f)
    elastic = stiffness(model.elasticity)
    rotation = rotation_matrix(quaternion(point.rotation))
    axes = product(rotation, elastic.axes)
    stress = congruence(transposed(axes), point.stress)
    problem = AnisotropicProblem(
        stress, elastic, axes, elastic_moduli(model.elasticity)[1], point.equivalent_plastic_strain,
        point.hardening_variable, point.temperature, 0.0, PRECISION,
    )  # fmt: skip
    xi = minus(deviator(point.stress), recovered(model.kinematic_hardening, 0.0, rows, k)[0])
    carried = carried_flow_stress(model.yield_condition, xi, mean(stress), 0.0)
    heat = warming(model, update.kinematics, point, j)
    continued = _continued(flow_before(model, point, j), carried, point, heat, problem.shear)
    returned = without_flow(problem)
    if not has_no_strength(model, point, j):
        returned = anisotropic_return(model.yield_condition, model, continued, problem, rows, k)
    step = AnisotropicStep(point, j, j, rotation, NO_STRESS, stress, problem, returned)
    linearise_anisotropic(update, rows, k, model, continued, step, place, stresses, tangents)

"""Hypoelastic-plastic stress update: rotated form with the Green-Naghdi rate, or another that a material asks for."""

from typing import NamedTuple

from core_models.compilation import inside_kernel
from core_models.laws import is_beyond_eos
from core_models.quaternions import quaternion, rotation_matrix, rotation_vector, turned
from core_models.rotation import rotation_increment, small_rotation_increment
from core_models.status import BEYOND_EOS, INVERTED, OK, UNSETTLED
from core_models.tensors import (
    congruence,
    contract,
    determinant,
    deviator,
    equivalent_stress,
    plus,
    product_transposed,
    scaled,
    symmetric_part,
)
from core_models.updates.conditions import shear_before
from core_models.updates.corotation import corotated
from core_models.updates.elastoplastic import advance_elastoplastic
from core_models.updates.interface import advance_rows, complete, predict, predict_carefully, stress_measure
from core_models.updates.prediction import NO_PREDICTION, Prediction


class HypoelasticPlastic(NamedTuple):
    """Hypoelastic-plastic update: additive split of the rate of deformation in the frame turned by R of F = V R.

        s_trial = Q [s_n + 2 G dev(d)] Q^T,   d = sym[2 (U - V_0) (U + V_0)^-1],   Q = R_1 R_0^T,   U = Q^T V_1 Q

    followed by the return to the yield surface in *Cauchy* stress; the pressure comes from the equation of state.
    d is the unrotated rate of deformation at mid-step, in the frame before the step: a superposed rotation changes Q
    only.

    Parameters
    ----------
    tolerance : relative tolerance of the consistency condition [-], in (0, 1e-3].

    With another objective rate (core_models.objective_rate) the stress turns further or less than by Q.
    R is updated incrementally (core_models.rotation), and V = F R^T. Objective to round-off for any rotation in a step.
    Source: Flanagan & Taylor (1987); Zocher et al., ECCOMAS (2000); the founding document, section 2.1.
    """

    tolerance: float = 1e-10


advance_rows.register(HypoelasticPlastic)(advance_elastoplastic)


@predict.register(HypoelasticPlastic)
def _(update, material, f0, f1, point):
    j0, j1 = determinant(f0), determinant(f1)
    r0, v0, a = unrotated(f0, f1, point.rotation)
    q, u, is_right = small_rotation_increment(a)
    status = OK if is_right and j1 > 0.0 and not is_beyond_eos(material.eos, j1) else UNSETTLED
    return status, elastic_trial(material, j0, j1, v0, u, q, point), rotation_vector(turned(q, r0))


@predict_carefully.register(HypoelasticPlastic)
def _(update, material, f0, f1, point):
    j0, j1 = determinant(f0), determinant(f1)
    if not j1 > 0.0:
        return INVERTED, NO_PREDICTION, point.rotation
    if is_beyond_eos(material.eos, j1):
        return BEYOND_EOS, NO_PREDICTION, point.rotation
    r0, v0, a = unrotated(f0, f1, point.rotation)
    q, u = rotation_increment(a)
    return OK, elastic_trial(material, j0, j1, v0, u, q, point), rotation_vector(turned(q, r0))


@inside_kernel
def unrotated(f0, f1, rotation):
    """Quaternion of R_0, V_0 = F_0 R_0^T, and F_1 R_0^T."""
    r0 = quaternion(rotation)
    r = rotation_matrix(r0)
    return r0, symmetric_part(product_transposed(f0, r)), product_transposed(f1, r)


@inside_kernel
def elastic_trial(material, j0, j1, v0, u, q, point):
    """Prediction from the volume ratios, the stretches before and after, the rotation and the state before."""
    shear = shear_before(material, point, j0)
    d, q = corotated(material.objective_rate, v0, u, q)
    s0 = deviator(point.stress)
    trial = plus(s0, scaled(deviator(d), 2.0 * shear))
    return Prediction(
        congruence(rotation_matrix(q), trial),
        j0,
        j1,
        equivalent_stress(trial),
        equivalent_stress(s0),
        3.0 * shear,
        contract(s0, d),
        contract(trial, d),
    )


@complete.register(HypoelasticPlastic)
def _(update, material, prediction, correction, point):
    stress = scaled(prediction.trial, correction.factor)
    mean_ratio = 0.5 * (prediction.volume_ratio_0 + prediction.volume_ratio_1)
    work = 0.5 * mean_ratio * (prediction.work + correction.factor * prediction.along_flow)
    return stress, work, point.elastic_left_cauchy_green


@stress_measure.register(HypoelasticPlastic)
def _(update, volume_ratio):
    return volume_ratio

"""Hyperelastic-plastic stress update: multiplicative split with the Simo-Hughes return mapping."""

from typing import NamedTuple

from core_models.compilation import inside_kernel
from core_models.laws import is_beyond_eos
from core_models.status import BEYOND_EOS, INVERTED, OK, UNSETTLED
from core_models.tensors import (
    THIRD,
    congruence,
    contract,
    cube_root,
    cube_root_near_one,
    determinant,
    deviator,
    equivalent_stress,
    inverse,
    is_near_one,
    plus_isotropic,
    product,
    scaled,
    symmetric_determinant,
    trace,
)
from core_models.updates.conditions import shear_before
from core_models.updates.elastoplastic import advance_elastoplastic
from core_models.updates.interface import advance_rows, complete, predict, predict_carefully, stress_measure
from core_models.updates.prediction import NO_PREDICTION, Prediction

NEWTON_STEPS = 6  # to round-off for a deviator up to 1/2, a yield stress of half the shear modulus


class HyperelasticPlastic(NamedTuple):
    """Hyperelastic-plastic update: F = F_e F_p, neo-Hookean deviator, radial return in *Kirchhoff* stress.

        b_trial = fbar b fbar^T,  fbar = J_f^(-1/3) F_1 F_0^-1,  tau_trial = G dev(b_trial)
        |tau_trial| - 2 Gbar dgamma = sqrt(2/3) sigma_y,  Gbar = G tr(b_trial) / 3
        b = tau / G + I 1 with det b = 1;  sigma = tau / J + p(J, e) 1

    b is the isochoric elastic left Cauchy-Green tensor.

    Parameters
    ----------
    tolerance : relative tolerance of the consistency condition [-], in (0, 1e-3].

    Variant: after the return the spherical part of b is set so that det b = 1 (the textbook keeps the trial's trace,
    which turns plastic work into spurious elastic energy). Objective to round-off for any rotation in a step.
    Source: Simo & Hughes, Computational Inelasticity (1998), box 9.1; Simo & Miehe, CMAME 98 (1992) 41.
    """

    tolerance: float = 1e-10


advance_rows.register(HyperelasticPlastic)(advance_elastoplastic)


@inside_kernel
def unimodular_mean(deviatoric):
    """Mean of the symmetric tensor of determinant 1 with a given deviator: det(deviatoric + x 1) = 1 by Newton.

    det = x^3 - x |d|^2 / 2 + det d increases and is convex right of its largest root; Newton's error squares each time.
    A fixed number of steps keeps the loop over points free of branches.
    """
    half_square = 0.5 * contract(deviatoric, deviatoric)
    constant = symmetric_determinant(deviatoric) - 1.0
    x = 1.0 + (half_square - constant - 1.0) * THIRD
    for _step in range(NEWTON_STEPS):
        x -= ((x * x - half_square) * x + constant) / (3.0 * x * x - half_square)
    return x


@predict.register(HyperelasticPlastic)
def _(update, material, f0, f1, point):
    j0, j1 = determinant(f0), determinant(f1)
    is_usual = is_near_one(j0 / j1) and j1 > 0.0 and not is_beyond_eos(material.eos, j1)
    status = OK if is_usual else UNSETTLED
    prediction = elastic_trial(material, f0, f1, j0, j1, cube_root_near_one(j0 / j1), point)
    return status, prediction, point.rotation


@predict_carefully.register(HyperelasticPlastic)
def _(update, material, f0, f1, point):
    j0, j1 = determinant(f0), determinant(f1)
    if not j1 > 0.0:
        return INVERTED, NO_PREDICTION, point.rotation
    if is_beyond_eos(material.eos, j1):
        return BEYOND_EOS, NO_PREDICTION, point.rotation
    prediction = elastic_trial(material, f0, f1, j0, j1, cube_root(j0 / j1), point)
    return OK, prediction, point.rotation


@inside_kernel
def elastic_trial(material, f0, f1, j0, j1, isochoric, point):
    """Prediction from the deformation gradients, their determinants and the cube root of J_0 / J_1."""
    shear = shear_before(material, point, j0)
    b0 = point.elastic_left_cauchy_green
    b_trial = scaled(congruence(product(f1, inverse(f0, j0)), b0), isochoric * isochoric)
    trial, before = scaled(deviator(b_trial), shear), scaled(deviator(b0), shear)
    return Prediction(
        trial,
        j0,
        j1,
        equivalent_stress(trial),
        equivalent_stress(before),
        shear * trace(b_trial),
        0.5 * shear * (trace(b_trial) - trace(b0)),
        0.0,
    )


@complete.register(HyperelasticPlastic)
def _(update, material, prediction, correction, point):
    over_shear = 1.0 / shear_before(material, point, prediction.volume_ratio_0)
    trial, factor = prediction.trial, correction.factor
    tau = scaled(trial, factor)
    # Trapezoidal rule: the part of the trial work that the return takes back. With the equivalent stress before,
    # not the old stress along the new flow direction, a rotation in the step changes nothing.
    work = prediction.work - 0.5 * correction.increment * (prediction.stress - prediction.stress_before)
    elastic = scaled(tau, over_shear)
    trial_mean = THIRD * prediction.shear_3 * over_shear
    return tau, work, plus_isotropic(elastic, trial_mean if factor == 1.0 else unimodular_mean(elastic))


@stress_measure.register(HyperelasticPlastic)
def _(update, volume_ratio):
    return 1.0

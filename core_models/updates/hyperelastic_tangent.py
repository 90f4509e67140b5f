"""Linearisation of the hyperelastic-plastic step."""

from typing import NamedTuple

from core_models.tensors import THIRD, contract, deviator, plus, plus_isotropic, scaled, trace
from core_models.updates.conditions import shear_before
from core_models.updates.elastoplastic_tangent import (
    kinematics,
    linearise_elastoplastic,
    measure_change,
    trial_change,
    work_change,
)
from core_models.updates.hyperelastic_plastic import HyperelasticPlastic
from core_models.updates.prediction import Prediction
from core_models.updates.tangent import linearise_rows, transported

TWO_THIRDS = 2.0 / 3.0


class IsochoricMotion(NamedTuple):
    """Isochoric elastic left Cauchy-Green tensor of the trial (six components) and shear modulus [Pa]."""

    elastic: tuple
    shear: float


linearise_rows.register(HyperelasticPlastic)(linearise_elastoplastic)


@kinematics.register(HyperelasticPlastic)
def _(update, material, f0, f1, point, prediction):
    shear = shear_before(material, point, prediction.volume_ratio_0)
    elastic = scaled(plus_isotropic(prediction.trial, THIRD * prediction.shear_3), 1.0 / shear)
    return IsochoricMotion(elastic, shear)


@trial_change.register(HyperelasticPlastic)
def _(update, motion, towards, prediction):
    """From b = (J_0 / J)^(2/3) f b_0 f^T: db = l b + b l^T - 2/3 tr(l) b."""
    relative = towards.relative
    expansion = relative[0] + relative[4] + relative[8]
    elastic = plus(transported(relative, motion.elastic), scaled(motion.elastic, -TWO_THIRDS * expansion))
    trial = scaled(deviator(elastic), motion.shear)
    stress = prediction.stress
    along = 1.5 * contract(prediction.trial, trial) / stress if stress > 0.0 else 0.0
    growth = motion.shear * trace(elastic)
    return Prediction(trial, 0.0, towards.volume_ratio, along, 0.0, growth, 0.5 * growth, 0.0)


@work_change.register(HyperelasticPlastic)
def _(update, prediction, correction, prediction_change, correction_change):
    taken_back = correction_change.increment * (prediction.stress - prediction.stress_before)
    return prediction_change.work - 0.5 * (taken_back + correction.increment * prediction_change.stress)


@measure_change.register(HyperelasticPlastic)
def _(update, volume_ratio_change):
    return 0.0

"""Linearisation of the hypoelastic-plastic step."""

from typing import NamedTuple

from core_models.laws import elastic_moduli
from core_models.quaternions import rotation_matrix
from core_models.rotation import asymmetry, rotation_increment, slightly_turned
from core_models.tensors import (
    congruence,
    contract,
    deviator,
    minus,
    plus,
    product_transposed,
    scaled,
    symmetric_inverse,
    symmetric_part,
    symmetric_part_of_product,
    transposed_product,
)
from core_models.updates.elastoplastic_tangent import (
    kinematics,
    linearise_elastoplastic,
    measure_change,
    trial_change,
    work_change,
)
from core_models.updates.hypoelastic_plastic import HypoelasticPlastic, unrotated
from core_models.updates.prediction import Prediction
from core_models.updates.tangent import full, linearise_rows


class UnrotatedMotion(NamedTuple):
    """The step in the frame before it, see `HypoelasticPlastic`.

    rotation_before : R_0. increment : Q (nine components). before, after : stretches V_0 and U; over_sum :
    (U + V_0)^-1; spin : (tr U 1 - U)^-1; trial : unrotated trial stress [Pa]; stress_before : deviator [Pa] (six
    components each). shear : modulus [Pa].
    """

    rotation_before: tuple
    increment: tuple
    before: tuple
    after: tuple
    over_sum: tuple
    spin: tuple
    rate: tuple
    trial: tuple
    stress_before: tuple
    shear: float


linearise_rows.register(HypoelasticPlastic)(linearise_elastoplastic)


@kinematics.register(HypoelasticPlastic)
def _(update, material, f0, f1, point, prediction):
    shear = elastic_moduli(material.elasticity)[1]
    r0, v0, a = unrotated(f0, f1, point.rotation)
    q, u = rotation_increment(a)
    over_sum = symmetric_inverse(plus(u, v0))
    d = scaled(symmetric_part_of_product(minus(u, v0), over_sum), 2.0)
    s0 = deviator(point.stress)
    spin = symmetric_inverse((u[1] + u[2], u[0] + u[2], u[0] + u[1], -u[3], -u[4], -u[5]))
    trial = plus(s0, scaled(deviator(d), 2.0 * shear))
    return UnrotatedMotion(
        rotation_matrix(r0), rotation_matrix(q), v0, u, over_sum, spin, d, trial, s0, shear
    )  # fmt: skip


@trial_change.register(HypoelasticPlastic)
def _(update, motion, towards, prediction):
    """With m = Q^T dF R_0^T: (tr U 1 - U) w = axial(m - m^T), dQ = Q [w], dU = sym(m - [w] U), and
    dd = 4 sym[V_0 (U + V_0)^-1 dU (U + V_0)^-1].
    """
    m = transposed_product(motion.increment, product_transposed(towards.gradient, motion.rotation_before))
    x, y, z = asymmetry(m)
    g = motion.spin
    spin = (
        g[0] * x + g[3] * y + g[5] * z,
        g[3] * x + g[1] * y + g[4] * z,
        g[5] * x + g[4] * y + g[2] * z,
    )
    stretch = plus(symmetric_part(m), minus(slightly_turned(motion.after, spin), motion.after))
    rate = scaled(symmetric_part_of_product(motion.before, congruence(full(motion.over_sum), stretch)), 4.0)
    change = scaled(deviator(rate), 2.0 * motion.shear)
    turning = scaled(minus(motion.trial, slightly_turned(motion.trial, spin)), 2.0)
    stress = prediction.stress
    return Prediction(
        congruence(motion.increment, plus(change, turning)),
        0.0,
        towards.volume_ratio,
        1.5 * contract(motion.trial, change) / stress if stress > 0.0 else 0.0,
        0.0,
        0.0,
        contract(motion.stress_before, rate),
        contract(change, motion.rate) + contract(motion.trial, rate),
    )


@work_change.register(HypoelasticPlastic)
def _(update, prediction, correction, prediction_change, correction_change):
    mean_ratio = 0.5 * (prediction.volume_ratio_0 + prediction.volume_ratio_1)
    rate = prediction.work + correction.factor * prediction.along_flow
    rate_change = (
        prediction_change.work
        + correction.factor * prediction_change.along_flow
        + correction_change.factor * prediction.along_flow
    )
    return 0.5 * (mean_ratio * rate_change + 0.5 * prediction_change.volume_ratio_1 * rate)


@measure_change.register(HypoelasticPlastic)
def _(update, volume_ratio_change):
    return volume_ratio_change

"""Linearisation of the hypoelastic-plastic step."""

from typing import NamedTuple

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
    transposed_product,
)
from core_models.updates.conditions import shear_before
from core_models.updates.corotation import corotated, corotated_change
from core_models.updates.elastoplastic_tangent import (
    kinematics,
    linearise_elastoplastic,
    measure_change,
    trial_change,
    work_change,
)
from core_models.updates.hypoelastic_plastic import HypoelasticPlastic, unrotated
from core_models.updates.prediction import Prediction
from core_models.updates.tangent import linearise_rows


class UnrotatedMotion(NamedTuple):
    """The step in the frame before it, see `HypoelasticPlastic`.

    objective_rate : law or None. rotation_before : R_0; increment : Q; whole : that of the rate's frame (nine
    components each). before, after : stretches V_0 and U; over_sum : (U + V_0)^-1; spin : (tr U 1 - U)^-1; strain : d;
    trial : trial stress [Pa]; stress_before : deviator [Pa] (six components each). shear : modulus [Pa].
    """

    objective_rate: tuple | None
    rotation_before: tuple
    increment: tuple
    whole: tuple
    before: tuple
    after: tuple
    over_sum: tuple
    spin: tuple
    strain: tuple
    trial: tuple
    stress_before: tuple
    shear: float


linearise_rows.register(HypoelasticPlastic)(linearise_elastoplastic)


@kinematics.register(HypoelasticPlastic)
def _(update, material, f0, f1, point, prediction):
    shear = shear_before(material, point, prediction.volume_ratio_0)
    r0, v0, a = unrotated(f0, f1, point.rotation)
    q, u = rotation_increment(a)
    over_sum = symmetric_inverse(plus(u, v0))
    d, whole = corotated(material.objective_rate, v0, u, q)
    s0 = deviator(point.stress)
    spin = symmetric_inverse((u[1] + u[2], u[0] + u[2], u[0] + u[1], -u[3], -u[4], -u[5]))
    trial = plus(s0, scaled(deviator(d), 2.0 * shear))
    return UnrotatedMotion(
        material.objective_rate, rotation_matrix(r0), rotation_matrix(q), rotation_matrix(whole), v0, u, over_sum,
        spin, d, trial, s0, shear,
    )  # fmt: skip


@trial_change.register(HypoelasticPlastic)
def _(update, motion, towards, prediction):
    """With m = Q^T dF R_0^T: (tr U 1 - U) w = axial(m - m^T), dQ = Q [w], dU = sym(m - [w] U)."""
    m = transposed_product(motion.increment, product_transposed(towards.gradient, motion.rotation_before))
    x, y, z = asymmetry(m)
    g = motion.spin
    spin = (
        g[0] * x + g[3] * y + g[5] * z,
        g[3] * x + g[1] * y + g[4] * z,
        g[5] * x + g[4] * y + g[2] * z,
    )
    stretch = plus(symmetric_part(m), minus(slightly_turned(motion.after, spin), motion.after))
    rate, spin = corotated_change(
        motion.objective_rate, motion.before, motion.after, motion.over_sum, stretch, spin
    )
    change = scaled(deviator(rate), 2.0 * motion.shear)
    turning = scaled(minus(motion.trial, slightly_turned(motion.trial, spin)), 2.0)
    stress = prediction.stress
    return Prediction(
        congruence(motion.whole, plus(change, turning)),
        0.0,
        towards.volume_ratio,
        1.5 * contract(motion.trial, change) / stress if stress > 0.0 else 0.0,
        0.0,
        0.0,
        contract(motion.stress_before, rate),
        contract(change, motion.strain) + contract(motion.trial, rate),
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

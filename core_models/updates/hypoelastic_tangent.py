"""Linearisation of the hypoelastic-plastic step."""

from typing import NamedTuple

from core_models.compilation import inside_kernel
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
    components each). before, after : stretches V_0 and U; over_sum : (U + V_0)^-1; spin : (tr U 1 - U)^-1; strain : d
    (six components each).
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


class UnrotatedTrial(NamedTuple):
    """A motion with the deviatoric trial stress that it leads to and that before (six components each) [Pa], and the
    shear modulus [Pa].
    """

    motion: UnrotatedMotion
    trial: tuple
    stress_before: tuple
    shear: float


linearise_rows.register(HypoelasticPlastic)(linearise_elastoplastic)


@inside_kernel
def unrotated_motion(objective_rate, f0, f1, rotation):
    """The step from f0, of the rotation vector given, to f1."""
    r0, v0, a = unrotated(f0, f1, rotation)
    q, u = rotation_increment(a)
    d, whole = corotated(objective_rate, v0, u, q)
    spin = symmetric_inverse((u[1] + u[2], u[0] + u[2], u[0] + u[1], -u[3], -u[4], -u[5]))
    return UnrotatedMotion(
        objective_rate, rotation_matrix(r0), rotation_matrix(q), rotation_matrix(whole), v0, u,
        symmetric_inverse(plus(u, v0)), spin, d,
    )  # fmt: skip


@inside_kernel
def strain_change(motion, towards):
    """Change of the strain increment in a direction, and the vector w of dQ = Q [w] of the rate's frame.

    With m = Q^T dF R_0^T: (tr U 1 - U) w = axial(m - m^T) for Q = R_1 R_0^T, dU = sym(m - [w] U).
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
    return corotated_change(
        motion.objective_rate, motion.before, motion.after, motion.over_sum, stretch, spin
    )


@kinematics.register(HypoelasticPlastic)
def _(update, material, f0, f1, point, prediction):
    motion = unrotated_motion(material.objective_rate, f0, f1, point.rotation)
    shear = shear_before(material, point, prediction.volume_ratio_0)
    s0 = deviator(point.stress)
    return UnrotatedTrial(motion, plus(s0, scaled(deviator(motion.strain), 2.0 * shear)), s0, shear)


@trial_change.register(HypoelasticPlastic)
def _(update, motion, towards, prediction):
    rate, spin = strain_change(motion.motion, towards)
    change = scaled(deviator(rate), 2.0 * motion.shear)
    turning = scaled(minus(motion.trial, slightly_turned(motion.trial, spin)), 2.0)
    stress = prediction.stress
    return Prediction(
        congruence(motion.motion.whole, plus(change, turning)),
        0.0,
        towards.volume_ratio,
        1.5 * contract(motion.trial, change) / stress if stress > 0.0 else 0.0,
        0.0,
        0.0,
        contract(motion.stress_before, rate),
        contract(change, motion.motion.strain) + contract(motion.trial, rate),
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

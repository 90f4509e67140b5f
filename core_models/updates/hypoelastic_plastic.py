"""Hypoelastic-plastic stress update: rotated form with the Green-Naghdi rate."""

import math
from typing import NamedTuple

from core_models.laws import advance_point, elastic_moduli, eroded_stress, is_beyond_eos
from core_models.rotation import rotation_increment
from core_models.state import PointState
from core_models.status import BEYOND_EOS, INVERTED
from core_models.tensors import (
    congruence,
    contract,
    determinant,
    deviator,
    minus,
    plus,
    plus_isotropic,
    product,
    scaled,
    symmetric_inverse,
    symmetric_part_of_product,
)
from core_models.updates.balance import NOTHING, Balance, advance_pressure, damaged, heated
from core_models.updates.plastic_return import returned


class HypoelasticPlastic(NamedTuple):
    """Hypoelastic-plastic update: additive split of the rate of deformation in the frame turned by R of F = V R.

        s_trial = Q s_n Q^T + 2 G dev(d),   d = sym[2 (V_1 - Q V_0 Q^T) (V_1 + Q V_0 Q^T)^-1],   Q = R_1 R_0^T

    followed by the return to the yield surface in *Cauchy* stress; the pressure comes from the equation of state.
    d is the unrotated rate of deformation at mid-step, pushed to the new frame: a superposed rotation changes Q only.

    Parameters
    ----------
    tolerance : relative tolerance of the consistency condition [-], in (0, 1e-3].

    V and R are updated incrementally (core_models.rotation). Objective to round-off for any rotation in a step.
    Source: Flanagan & Taylor (1987); Zocher et al., ECCOMAS (2000); the founding document, section 2.1.
    """

    tolerance: float = 1e-10


@advance_point.register(HypoelasticPlastic)
def _(update, material, viscosity, f0, f1, dt, length, point):
    j0, j1 = determinant(f0), determinant(f1)
    if not j1 > 0.0:
        return INVERTED, point, NOTHING
    if is_beyond_eos(material.eos, j1):
        return BEYOND_EOS, point, NOTHING
    shear = elastic_moduli(material.elasticity)[1]
    q, v1 = rotation_increment(f1, point.rotation)
    v0 = congruence(q, point.left_stretch)
    d = scaled(symmetric_part_of_product(minus(v1, v0), symmetric_inverse(plus(v1, v0))), 2.0)

    s0 = deviator(congruence(q, point.stress))
    trial = plus(s0, scaled(deviator(d), 2.0 * shear))
    factor, increment, flow_stress, hardening, status = returned(
        material, trial, 3.0 * shear, s0, dt, update.tolerance, point
    )
    s1 = eroded_stress(material.erosion, point.damage, scaled(trial, factor), 0.0)[0]
    deviatoric_work = 0.25 * (j0 + j1) * contract(plus(s0, s1), d)
    dissipation = j1 * flow_stress * increment
    p = advance_pressure(material, viscosity, j0, j1, dt, length, shear, deviatoric_work, point)
    after = PointState(
        plus_isotropic(s1, p.mean_stress),
        product(q, point.rotation),
        v1,
        point.elastic_left_cauchy_green,
        point.equivalent_plastic_strain + increment,
        hardening,
        heated(material, point.temperature, dissipation, p.viscous_work),
        damaged(material, point, increment, dt, p.mean_stress, flow_stress),
        p.energy,
    )
    speed = math.sqrt((p.bulk_modulus + 4.0 / 3.0 * shear) * j1 / material.density)
    return status, after, Balance(speed, p.viscous, deviatoric_work + p.work, dissipation, p.viscous_work)

"""Hyperelastic-plastic stress update: multiplicative split with the Simo-Hughes return mapping."""

import math
from typing import NamedTuple

from core_models.compilation import inside_kernel
from core_models.laws import advance_point, elastic_moduli, eroded_stress, is_beyond_eos
from core_models.state import PointState
from core_models.status import BEYOND_EOS, INVERTED
from core_models.tensors import (
    congruence,
    contract,
    determinant,
    deviator,
    equivalent_stress,
    inverse,
    plus_isotropic,
    product,
    scaled,
    symmetric_determinant,
    trace,
)
from core_models.updates.balance import NOTHING, Balance, advance_pressure, damaged, heated
from core_models.updates.plastic_return import returned


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


@inside_kernel
def unimodular(deviatoric):
    """Symmetric tensor of determinant 1 with a given deviator: solves det(deviatoric + x 1) = 1 for x by Newton.

    det = x^3 - x |d|^2 / 2 + det d has its largest root at or right of 1, where it is increasing and convex.
    """
    half_square = 0.5 * contract(deviatoric, deviatoric)
    constant = symmetric_determinant(deviatoric) - 1.0
    x = 1.0 + half_square / 3.0
    for _iteration in range(50):
        value = (x * x - half_square) * x + constant
        step = value / (3.0 * x * x - half_square)
        x -= step
        if abs(step) <= 1e-15 * x:
            break
    return plus_isotropic(deviatoric, x)


@advance_point.register(HyperelasticPlastic)
def _(update, material, viscosity, f0, f1, dt, length, point):
    j0, j1 = determinant(f0), determinant(f1)
    if not j1 > 0.0:
        return INVERTED, point, NOTHING
    if is_beyond_eos(material.eos, j1):
        return BEYOND_EOS, point, NOTHING
    shear = elastic_moduli(material.elasticity)[1]
    b0 = point.elastic_left_cauchy_green
    b_trial = scaled(congruence(product(f1, inverse(f0, j0)), b0), (j0 / j1) ** (2.0 / 3.0))
    trial = scaled(deviator(b_trial), shear)
    tau0 = scaled(deviator(b0), shear)
    factor, increment, flow_stress, hardening, status = returned(
        material, trial, shear * trace(b_trial), tau0, dt, update.tolerance, point
    )
    tau = eroded_stress(material.erosion, point.damage, scaled(trial, factor), 0.0)[0]
    b1 = b_trial if increment == 0.0 and tau[0] == trial[0] else unimodular(scaled(tau, 1.0 / shear))
    deviatoric_work = 0.5 * shear * (trace(b_trial) - trace(b0))
    if increment > 0.0:
        # Trapezoidal rule: the part of the trial work that the return takes back, along the flow direction.
        q = equivalent_stress(trial)
        along_flow = 1.5 * contract(trial, tau0) / q
        deviatoric_work -= 0.5 * increment * (q - along_flow)
    dissipation = flow_stress * increment
    p = advance_pressure(material, viscosity, j0, j1, dt, length, shear / j1, deviatoric_work, point)
    after = PointState(
        plus_isotropic(scaled(tau, 1.0 / j1), p.mean_stress),
        point.rotation,
        point.left_stretch,
        b1,
        point.equivalent_plastic_strain + increment,
        hardening,
        heated(material, point.temperature, dissipation, p.viscous_work),
        damaged(material, point, increment, dt, p.mean_stress, flow_stress / j1),
        p.energy,
    )
    speed = math.sqrt((p.bulk_modulus + 4.0 / 3.0 * shear / j1) * j1 / material.density)
    return status, after, Balance(speed, p.viscous, deviatoric_work + p.work, dissipation, p.viscous_work)

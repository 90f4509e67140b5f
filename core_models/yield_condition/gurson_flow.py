"""The local problem of a porous metal: what some plastic flow leads to, and what it leaves of the equations.

The unknowns are the deviatoric plastic strain s, the voids z = -ln(1 - f) and the plastic strain of the matrix p. In z
the volume of the voids is known to round-off at any porosity, also where pressure closes them:

    v_p = z - z_0(p),   z_0 = -ln(1 - f_0 - A(p)),   q = q_trial - 3 G s,   m = m(ln J_e - v_p)
"""

import math
from typing import NamedTuple

from core_models.compilation import beside_kernel, inside_kernel
from core_models.laws import nucleated
from core_models.tensors import determinant, inverse
from core_models.updates.general_problem import Strength, mean_stress, strength
from core_models.yield_condition.gurson_surface import (
    LARGEST_ARGUMENT,
    argument,
    carrying_share,
    effective_porosity,
)

CLOSED = 1e-15  # porosity of voids that pressure has closed for good
WEAKEST = 1e-3  # Pa; below, the round-off of the elasticity is larger
WHOLE = 1.0 - 1e-12  # largest porosity that a step starts from


class VoidFlow(NamedTuple):
    """What values of the unknowns lead to: plastic volume and its slope by p, von Mises' and the mean stress with its
    slope, flow stress and its slope [Pa], hardening variable.
    """

    shape: float
    voids: float
    increment: float
    volume: float
    nucleation: float
    mises: float
    mean_stress: float
    bulk: float
    flow: float
    hardening: float
    variable: float


@inside_kernel
def voids_before(damage, problem, increment):
    """z_0 after an increment of plastic strain of the matrix that nucleates voids, and its slope."""
    added, rate = nucleated(damage, problem.plastic_strain, increment)
    porosity = added + (problem.porosity if problem.porosity > CLOSED else 0.0)
    if porosity >= WHOLE:
        return -math.log1p(-WHOLE), 0.0
    return -math.log1p(-porosity), rate / (1.0 - porosity)


@inside_kernel
def porosity_of(voids):
    """f = 1 - exp(-z)."""
    return -math.expm1(-voids)


@beside_kernel
def matrix_strength(flow, problem, increment):
    """`Strength` of the matrix after an increment of plastic strain, never so small that nothing can be over it."""
    now = strength(flow, problem, increment)
    return Strength(max(now.stress, WEAKEST), now.slope, now.variable)


@beside_kernel
def flowing(model, flow, problem, mises, shape, voids, increment):
    """`VoidFlow` of some unknowns. mises : that of the trial [Pa]."""
    now = matrix_strength(flow, problem, increment)
    start, rate = voids_before(model.damage, problem, increment)
    volume = voids - start
    stress, bulk = mean_stress(model.eos, problem, problem.volume - volume)
    return VoidFlow(
        shape, voids, increment, volume, -rate, mises - 3.0 * problem.shear * shape, stress, bulk, now.stress,
        now.slope, now.variable,
    )  # fmt: skip


@beside_kernel
def residual(law, now):
    """Yield function, normality and equality of work, without dimensions.

    A pressure beyond that at which voids have closed does no work on them.
    """
    f = effective_porosity(law, porosity_of(now.voids))[0]
    x, q = argument(law, now.mean_stress, now.flow), now.mises / now.flow
    return (
        q * q + 2.0 * law.q1 * f * math.cosh(x) - 1.0 - law.q3 * f * f,
        2.0 * now.volume * q - 3.0 * law.q1 * law.q2 * now.shape * f * math.sinh(x),
        now.increment * carrying_share(law, porosity_of(now.voids))[0] - work_over_flow(law, now, x),
    )


@inside_kernel
def work_over_flow(law, now, x):
    """Plastic work of the body over the flow stress of the matrix, with the argument x of cosh."""
    return now.mises / now.flow * now.shape + x / (1.5 * law.q2) * now.volume


@beside_kernel
def residual_change(law, problem, now, shape, voids, increment, mises, stress):
    """Change of the residuals with the unknowns, and with the equivalent and the mean stress of the trial."""
    porosity = porosity_of(now.voids)
    f, f_slope = effective_porosity(law, porosity)
    share, share_slope = carrying_share(law, porosity)
    x, q = argument(law, now.mean_stress, now.flow), now.mises / now.flow
    ch, sh = math.cosh(x), math.sinh(x)
    hardened = now.hardening * increment / now.flow
    volume = voids + now.nucleation * increment
    q_change = (mises - 3.0 * problem.shear * shape) / now.flow - q * hardened
    turn = 1.5 * law.q2 * (stress - now.bulk * volume) / now.flow - x * hardened
    turn = turn if abs(x) < LARGEST_ARGUMENT else 0.0
    grown = (1.0 - porosity) * voids
    f_change = f_slope * grown
    c = 3.0 * law.q1 * law.q2
    work = q_change * now.shape + q * shape + (turn * now.volume + x * volume) / (1.5 * law.q2)
    return (
        2.0 * q * q_change + 2.0 * law.q1 * (ch * f_change + f * sh * turn) - 2.0 * law.q3 * f * f_change,
        2.0 * (q * volume + now.volume * q_change)
        - c * (f * sh * shape + now.shape * (sh * f_change + f * ch * turn)),
        share * increment + now.increment * share_slope * grown - work,
    )


@beside_kernel
def solved(law, problem, now, right):
    """Change of the unknowns that changes the residuals by `right`, and whether there is one."""
    a = residual_change(law, problem, now, 1.0, 0.0, 0.0, 0.0, 0.0)
    b = residual_change(law, problem, now, 0.0, 1.0, 0.0, 0.0, 0.0)
    c = residual_change(law, problem, now, 0.0, 0.0, 1.0, 0.0, 0.0)
    matrix = (a[0], b[0], c[0], a[1], b[1], c[1], a[2], b[2], c[2])
    det = determinant(matrix)
    if det == 0.0 or not math.isfinite(det):
        return (0.0, 0.0, 0.0), False
    m = inverse(matrix, det)
    change = (
        m[0] * right[0] + m[1] * right[1] + m[2] * right[2],
        m[3] * right[0] + m[4] * right[1] + m[5] * right[2],
        m[6] * right[0] + m[7] * right[1] + m[8] * right[2],
    )
    return change, math.isfinite(change[0] + change[1] + change[2])

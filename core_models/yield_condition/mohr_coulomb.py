"""Mohr-Coulomb yield condition with dilation, corners, apex and tension cut-off."""

import math
from typing import NamedTuple

from core_models.compilation import beside_kernel, inside_kernel
from core_models.principal_axes import from_principal, principal, to_principal
from core_models.tensors import congruence, determinant, inverse
from core_models.updates.general_problem import (
    ELASTIC,
    NO_STRESS,
    Returned,
    allowance,
    mean_stress,
    return_change,
    return_stress,
    status_of,
    strength,
    unchanged,
    volume_at,
)

MAXIMUM_ITERATIONS = 50
DEGREE = math.pi / 180.0
NO_PLANE = -1
# Planes of the sector s_1 >= s_2 >= s_3: Mohr-Coulomb's 0 (s_1, s_3), 1 (s_1, s_2), 2 (s_2, s_3); the cut-off's 3, 4, 5
# (s_1, s_2, s_3). Regimes: the planes that may be active together, the most frequent first; after them the apex.
PLANES = (
    (0, NO_PLANE, NO_PLANE),
    (0, 1, NO_PLANE),
    (0, 2, NO_PLANE),
    (3, NO_PLANE, NO_PLANE),
    (3, 4, NO_PLANE),
    (3, 0, NO_PLANE),
    (3, 0, 1),
    (3, 4, 0),
    (3, 0, 2),
)
APEX = len(PLANES) + 1
CLOSE = 1e-6  # of the largest principal stress: principal values that count as equal


class MohrCoulomb(NamedTuple):
    """Mohr-Coulomb: s_1 - s_3 + (s_1 + s_3) sin(friction) <= 2 c cos(friction), and s_1 <= tension_cutoff.

    Principal stresses s_1 >= s_2 >= s_3, positive in tension; c is the material's flow law. Flow on each plane follows
    the same expression with the angle of dilation, on the cut-off the normal; at edges the planes flow together, and at
    the apex s = c cot(friction) the volume grows as it must. Friction 0 is Tresca's condition with sigma_y = 2 c.

    Parameters
    ----------
    friction_angle : [degree], 0 <= friction_angle < 90. dilation_angle : [degree], from 0 to the friction angle.
    tension_cutoff : largest principal stress [Pa], > 0; infinite for none.

    Valid with flow laws that feel no rate. Hardening is by the deviatoric plastic strain, as everywhere here.
    Source: de Souza Neto, Peric & Owen, Computational Methods for Plasticity (2008), section 8.2.
    """

    friction_angle: float
    dilation_angle: float
    tension_cutoff: float = math.inf

    has_plastic_volume = True

    def fault(self) -> str:
        """What is wrong with the parameters taken together; empty if nothing is."""
        if self.dilation_angle > self.friction_angle:
            return (
                f"the dilation angle {self.dilation_angle:g} is above the friction angle {self.friction_angle:g}, "
                "which would create energy: give dilation_angle <= friction_angle"
            )
        return ""


class PlaneFlow(NamedTuple):
    """State of the iteration for some active planes: principal stresses, ln J_e, mean stress and slope [Pa], increment
    of plastic strain and its slopes by the three multipliers, cohesion and its slope [Pa].
    """

    stress: tuple
    volume: float
    mean_stress: float
    bulk: float
    increment: float
    slopes: tuple
    cohesion: float
    hardening: float
    variable: float


@inside_kernel
def plane(angle, index):
    """Gradient by the principal stresses of a plane of Mohr-Coulomb with an angle [degree], or of the cut-off."""
    sine = math.sin(angle * DEGREE)
    up, down = 1.0 + sine, sine - 1.0
    if index == 0:
        return (up, 0.0, down)
    if index == 1:
        return (up, down, 0.0)
    if index == 2:
        return (0.0, up, down)
    if index == 3:
        return (1.0, 0.0, 0.0)
    if index == 4:
        return (0.0, 1.0, 0.0)
    if index == 5:
        return (0.0, 0.0, 1.0)
    return (0.0, 0.0, 0.0)


@inside_kernel
def cohesion_factor(law, index):
    """What the cohesion is multiplied by in the bound of a plane."""
    return 2.0 * math.cos(law.friction_angle * DEGREE) if 0 <= index <= 2 else 0.0


@inside_kernel
def excess(law, index, stress, cohesion):
    """How far principal stresses lie beyond a plane [Pa]."""
    if index == NO_PLANE:
        return 0.0
    bound = law.tension_cutoff if index >= 3 else cohesion_factor(law, index) * cohesion
    return dot(plane(law.friction_angle, index), stress) - bound


@inside_kernel
def dot(a, b):
    """Scalar product."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@beside_kernel
def largest_excess(law, stress, cohesion):
    """How far ordered principal stresses lie beyond the surface [Pa]."""
    return max(excess(law, 0, stress, cohesion), excess(law, 3, stress, cohesion))


@inside_kernel
def shifted(values, p):
    """Principal values with p added."""
    return (values[0] + p, values[1] + p, values[2] + p)


@return_stress.register(MohrCoulomb)
def _(yield_condition, model, flow, problem, rows, k):
    stress, bulk = mean_stress(model.eos, problem, problem.volume)
    values, axes = principal(problem.trial)
    cohesion = strength(flow, problem, 0.0).stress
    if largest_excess(yield_condition, shifted(values, stress), cohesion) <= 0.0:
        return unchanged(problem, stress, bulk)
    return _search(yield_condition, model, flow, problem, values, axes, bulk)


@beside_kernel
def _search(law, model, flow, problem, values, axes, bulk):
    """The first set of active planes whose return ends on the surface with principal stresses in order, or the apex."""
    limit = _limit(flow, problem, values, bulk)
    for regime in range(1, APEX):
        planes = PLANES[regime - 1]
        if planes[0] >= 3 and law.tension_cutoff == math.inf:
            break
        converged, gammas, now = _flow_on(law, model, flow, problem, values, planes, limit)
        if converged and _is_admissible(law, gammas, now, 10.0 * limit):
            m = now.mean_stress
            deviator = from_principal(shifted(now.stress, -m), axes)
            return Returned(
                status_of(True), regime, deviator, now.volume, m, now.bulk, now.increment, now.variable,
                problem.porosity, 0.0,
            )  # fmt: skip
    return _apex(law, model, flow, problem, values, limit)


@inside_kernel
def _limit(flow, problem, values, bulk):
    """How far from the surface a return may end [Pa]."""
    return allowance(problem, values[0] - values[2] + 2.0 * strength(flow, problem, 0.0).stress, bulk)


@inside_kernel
def _is_admissible(law, gammas, now, limit):
    """Whether a return has flowed forwards, kept the order of the principal stresses and ended on the surface."""
    s = now.stress
    is_ordered = s[0] - s[1] >= -limit and s[1] - s[2] >= -limit
    is_forward = min(gammas[0], gammas[1], gammas[2]) >= 0.0
    return is_ordered and is_forward and largest_excess(law, s, now.cohesion) <= limit


@beside_kernel
def _apex(law, model, flow, problem, values, limit):
    """Return to the point where all principal stresses are equal."""
    increment = math.sqrt(dot(values, values) / 6.0) / problem.shear
    now = strength(flow, problem, increment)
    target = _apex_stress(law, now.stress)
    volume, stress, bulk = volume_at(model.eos, problem, target, limit)
    converged = abs(stress - target) <= limit and volume <= problem.volume
    return Returned(
        status_of(converged), APEX, NO_STRESS, volume, stress, bulk, increment, now.variable,
        problem.porosity, 0.0,
    )  # fmt: skip


@inside_kernel
def _apex_stress(law, cohesion):
    """Largest mean stress [Pa]."""
    tangent = math.tan(law.friction_angle * DEGREE)
    return min(law.tension_cutoff, cohesion / tangent if tangent > 0.0 else math.inf)


@inside_kernel
def plastic_strain(law, planes, gammas):
    """Deviatoric principal plastic strains, and the plastic growth of the volume, of some multipliers."""
    a, b, c = (plane(law.dilation_angle, planes[0]), plane(law.dilation_angle, planes[1]),
               plane(law.dilation_angle, planes[2]))  # fmt: skip
    strain = (
        gammas[0] * a[0] + gammas[1] * b[0] + gammas[2] * c[0],
        gammas[0] * a[1] + gammas[1] * b[1] + gammas[2] * c[1],
        gammas[0] * a[2] + gammas[1] * b[2] + gammas[2] * c[2],
    )
    growth = strain[0] + strain[1] + strain[2]
    e = shifted(strain, -growth / 3.0)
    return (e[0], e[1], e[2], growth)


@beside_kernel
def _flowing(law, model, flow, problem, values, planes, gammas):
    """What some multipliers of the active planes lead to."""
    strain = plastic_strain(law, planes, gammas)
    growth = strain[3]
    increment = math.sqrt(2.0 / 3.0 * dot(strain, strain))
    slopes = (
        _slope(plane(law.dilation_angle, planes[0]), strain, increment),
        _slope(plane(law.dilation_angle, planes[1]), strain, increment),
        _slope(plane(law.dilation_angle, planes[2]), strain, increment),
    )
    volume = problem.volume - growth
    stress, bulk = mean_stress(model.eos, problem, volume)
    g = 2.0 * problem.shear
    total = (
        values[0] - g * strain[0] + stress, values[1] - g * strain[1] + stress, values[2] - g * strain[2] + stress
    )  # fmt: skip
    now = strength(flow, problem, increment)
    return PlaneFlow(total, volume, stress, bulk, increment, slopes, now.stress, now.slope, now.variable)


@inside_kernel
def _slope(direction, strain, increment):
    """Slope of the increment of plastic strain by the multiplier of a plane."""
    mean = (direction[0] + direction[1] + direction[2]) / 3.0
    if increment > 0.0:
        return 2.0 / 3.0 * dot(shifted(direction, -mean), strain) / increment
    return math.sqrt(2.0 / 3.0 * (dot(direction, direction) - 3.0 * mean * mean))


@inside_kernel
def _matrix_row(law, problem, planes, now, row):
    """Slopes of the excess over an active plane by the three multipliers, with the sign changed."""
    return (
        _entry(law, problem, planes, now, row, 0),
        _entry(law, problem, planes, now, row, 1),
        _entry(law, problem, planes, now, row, 2),
    )


@inside_kernel
def _entry(law, problem, planes, now, row, column):
    if planes[row] == NO_PLANE or planes[column] == NO_PLANE:
        return 1.0 if row == column else 0.0
    n, m = plane(law.friction_angle, planes[row]), plane(law.dilation_angle, planes[column])
    growth = m[0] + m[1] + m[2]
    elastic = 2.0 * problem.shear * dot(n, shifted(m, -growth / 3.0)) + now.bulk * growth * (
        n[0] + n[1] + n[2]
    )
    return elastic + cohesion_factor(law, planes[row]) * now.hardening * now.slopes[column]


@beside_kernel
def _matrix(law, problem, planes, now):
    a, b, c = (_matrix_row(law, problem, planes, now, 0), _matrix_row(law, problem, planes, now, 1),
               _matrix_row(law, problem, planes, now, 2))  # fmt: skip
    return (a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2])


@inside_kernel
def _solved(matrix, det, right):
    i = inverse(matrix, det)
    return (
        i[0] * right[0] + i[1] * right[1] + i[2] * right[2],
        i[3] * right[0] + i[4] * right[1] + i[5] * right[2],
        i[6] * right[0] + i[7] * right[1] + i[8] * right[2],
    )


@beside_kernel
def _flow_on(law, model, flow, problem, values, planes, limit):
    """Multipliers of the active planes by Newton's method: converged or not, multipliers, `PlaneFlow`."""
    gammas = (0.0, 0.0, 0.0)
    now = _flowing(law, model, flow, problem, values, planes, gammas)
    for _iteration in range(MAXIMUM_ITERATIONS):
        right = (
            excess(law, planes[0], now.stress, now.cohesion),
            excess(law, planes[1], now.stress, now.cohesion),
            excess(law, planes[2], now.stress, now.cohesion),
        )
        if max(abs(right[0]), abs(right[1]), abs(right[2])) <= limit:
            return True, gammas, now
        matrix = _matrix(law, problem, planes, now)
        det = determinant(matrix)
        if det == 0.0 or not math.isfinite(det):
            break
        step = _solved(matrix, det, right)
        gammas = (gammas[0] + step[0], gammas[1] + step[1], gammas[2] + step[2])
        now = _flowing(law, model, flow, problem, values, planes, gammas)
    return False, gammas, now


@return_change.register(MohrCoulomb)
def _(yield_condition, model, flow, problem, returned, rows, k, trial, shear, mean, spin):
    if returned.regime == ELASTIC:
        return trial, mean
    values, axes = principal(problem.trial)
    change = to_principal(trial, axes)
    if returned.regime == APEX:
        return NO_STRESS, _apex_change(yield_condition, flow, problem, returned, values, change, shear)
    return _change(yield_condition, model, flow, problem, returned, values, axes, change, shear, mean)


@beside_kernel
def _apex_change(law, flow, problem, returned, values, change, shear):
    """Change of the mean stress at the apex, by the hardening of the cohesion."""
    tangent = math.tan(law.friction_angle * DEGREE)
    now = strength(flow, problem, returned.increment)
    if returned.increment == 0.0 or not now.stress < law.tension_cutoff * tangent:
        return 0.0
    growth = dot(values, change) / (6.0 * problem.shear * problem.shear * returned.increment)
    return now.slope / tangent * (growth - returned.increment * shear / problem.shear)


@beside_kernel
def _change(law, model, flow, problem, returned, values, axes, change, shear, mean):
    """Change of deviator and mean stress on some planes: of the principal stresses, and of their axes."""
    planes = PLANES[returned.regime - 1]
    limit = _limit(flow, problem, values, returned.bulk)
    _converged, gammas, now = _flow_on(law, model, flow, problem, values, planes, limit)
    matrix = _matrix(law, problem, planes, now)
    strain = plastic_strain(law, planes, gammas)
    values_change, mean_change = _principal_change(
        law, problem, planes, now, matrix, strain, change, shear, mean
    )
    deviator = shifted(values_change, -mean_change)
    s = (
        deviator[0], deviator[1], deviator[2],
        change[3] * _turning(law, problem, planes, now, matrix, strain, values, 0, 1),
        change[4] * _turning(law, problem, planes, now, matrix, strain, values, 1, 2),
        change[5] * _turning(law, problem, planes, now, matrix, strain, values, 2, 0),
    )  # fmt: skip
    return congruence(axes, s), mean_change


@beside_kernel
def _principal_change(law, problem, planes, now, matrix, strain, change, shear, mean):
    """Change of principal and mean stresses for that of the trial, the shear modulus and the mean stress."""
    g = 2.0 * shear
    bare = (
        change[0] - g * strain[0] + mean,
        change[1] - g * strain[1] + mean,
        change[2] - g * strain[2] + mean,
    )
    right = (
        _along(law, planes[0], bare),
        _along(law, planes[1], bare),
        _along(law, planes[2], bare),
    )
    moved = plastic_strain(law, planes, _solved(matrix, determinant(matrix), right))
    growth = moved[3]
    g = 2.0 * problem.shear
    p = now.bulk * growth
    total = (bare[0] - g * moved[0] - p, bare[1] - g * moved[1] - p, bare[2] - g * moved[2] - p)
    return total, mean - p


@inside_kernel
def _along(law, index, change):
    """Change of the excess over a plane by that of the stresses."""
    return dot(plane(law.friction_angle, index), change)


@inside_kernel
def _turning(law, problem, planes, now, matrix, strain, values, i, j):
    """(s_i - s_j) / (t_i - t_j) of stresses s and trial stresses t, and its limit where the latter are equal."""
    gap = values[i] - values[j]
    if abs(gap) > CLOSE * (values[0] - values[2]):
        return (now.stress[i] - now.stress[j]) / gap
    towards = (unit(0, i) - unit(0, j), unit(1, i) - unit(1, j), unit(2, i) - unit(2, j))
    change, _mean = _principal_change(law, problem, planes, now, matrix, strain, towards, 0.0, 0.0)
    return 0.5 * (change[i] - change[j])


@inside_kernel
def unit(number, component):
    """1 for equal numbers, else 0."""
    return 1.0 if number == component else 0.0

"""The planes of Mohr and Coulomb's surface and of its cut-off, in principal stresses, and the flow on some of them.

s = s_trial - 2 G dev(e_p) - K tr(e_p),   e_p = sum of dgamma_i m_i,   n_j . s = bound_j  on each active plane
"""

import math
from typing import NamedTuple

from core_models.compilation import beside_kernel, inside_kernel
from core_models.tensors import determinant, inverse
from core_models.updates.general_problem import allowance, mean_stress, strength
from core_models.updates.root import next_guess

MAXIMUM_ITERATIONS = 50
DEGREE = math.pi / 180.0
NO_PLANE = -1
# Planes of the sector s_1 >= s_2 >= s_3: Mohr-Coulomb's 0 (s_1, s_3), 1 (s_1, s_2), 2 (s_2, s_3); the cut-off's 3, 4, 5
# (s_1, s_2, s_3). Regimes: the planes that may be active together, the most frequent first; from the one after them on
# the kinds of flow at the apex.
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


class PlaneFlow(NamedTuple):
    """What multipliers of the active planes lead to: principal stresses, ln J_e, mean stress and slope [Pa], increment
    of plastic strain and its slopes by the three multipliers.
    """

    stress: tuple
    volume: float
    mean_stress: float
    bulk: float
    increment: float
    slopes: tuple


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


@inside_kernel
def shifted_values(values, p):
    """Principal values with p added."""
    return (values[0] + p, values[1] + p, values[2] + p)


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
    e = shifted_values(strain, -growth / 3.0)
    return (e[0], e[1], e[2], growth)


@beside_kernel
def flowing(law, model, problem, values, planes, gammas):
    """What some multipliers of the active planes lead to: `PlaneFlow`."""
    strain = plastic_strain(law, planes, gammas)
    increment = math.sqrt(2.0 / 3.0 * dot(strain, strain))
    slopes = (
        _slope(plane(law.dilation_angle, planes[0]), strain, increment),
        _slope(plane(law.dilation_angle, planes[1]), strain, increment),
        _slope(plane(law.dilation_angle, planes[2]), strain, increment),
    )
    volume = problem.volume - strain[3]
    stress, bulk = mean_stress(model.eos, problem, volume)
    g = 2.0 * problem.shear
    total = (
        values[0] - g * strain[0] + stress, values[1] - g * strain[1] + stress, values[2] - g * strain[2] + stress
    )  # fmt: skip
    return PlaneFlow(total, volume, stress, bulk, increment, slopes)


@inside_kernel
def _slope(direction, strain, increment):
    """Slope of the increment of plastic strain by the multiplier of a plane."""
    mean = (direction[0] + direction[1] + direction[2]) / 3.0
    if increment > 0.0:
        return 2.0 / 3.0 * dot(shifted_values(direction, -mean), strain) / increment
    return math.sqrt(2.0 / 3.0 * (dot(direction, direction) - 3.0 * mean * mean))


@beside_kernel
def slopes_of_excess(law, problem, planes, now, hardening):
    """Slopes of the excess over the active planes by the multipliers, with the sign changed (nine components).

    Parameters
    ----------
    hardening : slope of the cohesion by plastic strain [Pa].
    """
    a, b, c = (_slopes_of_plane(law, problem, planes, now, hardening, 0),
               _slopes_of_plane(law, problem, planes, now, hardening, 1),
               _slopes_of_plane(law, problem, planes, now, hardening, 2))  # fmt: skip
    return (a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2])


@inside_kernel
def _slopes_of_plane(law, problem, planes, now, hardening, row):
    return (
        _entry(law, problem, planes, now, hardening, row, 0),
        _entry(law, problem, planes, now, hardening, row, 1),
        _entry(law, problem, planes, now, hardening, row, 2),
    )


@inside_kernel
def _entry(law, problem, planes, now, hardening, row, column):
    if planes[row] == NO_PLANE or planes[column] == NO_PLANE:
        return 1.0 if row == column else 0.0
    n, m = plane(law.friction_angle, planes[row]), plane(law.dilation_angle, planes[column])
    growth = m[0] + m[1] + m[2]
    elastic = 2.0 * problem.shear * dot(n, shifted_values(m, -growth / 3.0)) + now.bulk * growth * (
        n[0] + n[1] + n[2]
    )
    return elastic + cohesion_factor(law, planes[row]) * hardening * now.slopes[column]


@inside_kernel
def solved(matrix, det, right):
    """Solution of three linear equations, given the determinant of their matrix."""
    i = inverse(matrix, det)
    return (
        i[0] * right[0] + i[1] * right[1] + i[2] * right[2],
        i[3] * right[0] + i[4] * right[1] + i[5] * right[2],
        i[6] * right[0] + i[7] * right[1] + i[8] * right[2],
    )


@beside_kernel
def flow_on(law, model, flow, problem, values, planes):
    """Multipliers of the active planes: converged or not, multipliers, `PlaneFlow`, increment of plastic strain, and
    how far off the stress may be [Pa].

    With the cohesion of an increment of plastic strain the planes give an increment; the root of their difference is
    the increment sought. It falls where the cohesion rises, however steeply: so steeply that the increment which gives
    the cohesion is not to be had from the difference of stresses.
    """
    low, high, tried = 0.0, 2.0 * (values[0] - values[2]) / problem.shear, 0.0
    gammas = (0.0, 0.0, 0.0)
    bound = (
        cohesion_factor(law, planes[0]),
        cohesion_factor(law, planes[1]),
        cohesion_factor(law, planes[2]),
    )
    at = strength(flow, problem, 0.0)
    bulk = mean_stress(model.eos, problem, problem.volume)[1]
    for _iteration in range(2 * MAXIMUM_ITERATIONS):
        limit = allowance(problem, at.stress, bulk)
        converged, gammas, now = _flow_under(law, model, problem, values, planes, gammas, at.stress, limit)
        if not converged:
            break
        # A cohesion that is too high for any flow makes it go backwards.
        sign = 1.0 if dot(bound, gammas) >= 0.0 else -1.0
        residual = sign * now.increment - tried
        factor = cohesion_factor(law, 0)
        is_consistent = abs(factor * (strength(flow, problem, now.increment).stress - at.stress)) <= limit
        if sign > 0.0 and is_consistent:
            return True, gammas, now, now.increment, limit
        if high - low <= 1e-15 * high:
            return True, gammas, now, tried, limit
        if residual > 0.0:
            low = tried
        else:
            high = tried
        matrix = slopes_of_excess(law, problem, planes, now, 0.0)
        fall = sign * dot(now.slopes, solved(matrix, determinant(matrix), bound))
        # From an increment of nothing, where cohesion may rise without bound, to the largest that the planes give.
        tried = (
            now.increment if tried == 0.0 else next_guess(tried, residual, -1.0 - fall * at.slope, low, high)
        )
        at = strength(flow, problem, tried)
    return False, gammas, flowing(law, model, problem, values, planes, gammas), 0.0, 0.0


@beside_kernel
def _flow_under(law, model, problem, values, planes, gammas, cohesion, limit):
    """Multipliers of the active planes under a cohesion by Newton's method."""
    now = flowing(law, model, problem, values, planes, gammas)
    for _iteration in range(MAXIMUM_ITERATIONS):
        right = (
            excess(law, planes[0], now.stress, cohesion),
            excess(law, planes[1], now.stress, cohesion),
            excess(law, planes[2], now.stress, cohesion),
        )
        # One step more, to round-off: cohesion that rises steeply with the rate feels the last digit of the increment.
        is_near = max(abs(right[0]), abs(right[1]), abs(right[2])) <= limit
        matrix = slopes_of_excess(law, problem, planes, now, 0.0)
        det = determinant(matrix)
        if det == 0.0 or not math.isfinite(det):
            return is_near, gammas, now
        step = solved(matrix, det, right)
        gammas = (gammas[0] + step[0], gammas[1] + step[1], gammas[2] + step[2])
        now = flowing(law, model, problem, values, planes, gammas)
        if is_near:
            return True, gammas, now
    return False, gammas, now

"""Return to Mohr and Coulomb's surface: to a plane, an edge, a corner or the apex."""

import math

from core_models.compilation import beside_kernel, inside_kernel
from core_models.principal_axes import from_principal, principal
from core_models.updates.general_problem import (
    NO_STRESS,
    Returned,
    allowance,
    mean_stress,
    return_stress,
    status_of,
    strength,
    unchanged,
    volume_at,
)
from core_models.yield_condition.mohr_coulomb import MohrCoulomb
from core_models.yield_condition.mohr_coulomb_planes import (
    APEX,
    DEGREE,
    PLANES,
    dot,
    excess,
    flow_on,
    shifted_values,
)


@return_stress.register(MohrCoulomb)
def _(yield_condition, model, flow, problem, rows, k):
    stress, bulk = mean_stress(model.eos, problem, problem.volume)
    values, axes = principal(problem.trial)
    cohesion = strength(flow, problem, 0.0).stress
    if _largest_excess(yield_condition, shifted_values(values, stress), cohesion) <= 0.0:
        return unchanged(problem, stress, bulk)
    return _search(yield_condition, model, flow, problem, values, axes)


@inside_kernel
def _largest_excess(law, stress, cohesion):
    """How far ordered principal stresses lie beyond the surface [Pa]."""
    return max(excess(law, 0, stress, cohesion), excess(law, 3, stress, cohesion))


@beside_kernel
def _search(law, model, flow, problem, values, axes):
    """The first set of active planes whose return ends on the surface with principal stresses in order, or the apex."""
    for regime in range(1, APEX):
        planes = PLANES[regime - 1]
        if planes[0] >= 3 and law.tension_cutoff == math.inf:
            break
        converged, gammas, now, increment, limit = flow_on(law, model, flow, problem, values, planes)
        cohesion = strength(flow, problem, increment)
        if converged and _is_admissible(law, problem, gammas, now.stress, cohesion.stress, 10.0 * limit):
            m = now.mean_stress
            deviator = from_principal(shifted_values(now.stress, -m), axes)
            return Returned(
                status_of(True), regime, deviator, now.volume, m, now.bulk, increment, cohesion.variable,
                problem.porosity, 0.0,
            )  # fmt: skip
    return _apex(law, model, flow, problem, values)


@inside_kernel
def _is_admissible(law, problem, gammas, stress, cohesion, limit):
    """Whether a return has flowed forwards, kept the order of the principal stresses and ended on the surface."""
    is_ordered = stress[0] - stress[1] >= -limit and stress[1] - stress[2] >= -limit
    is_forward = min(gammas[0], gammas[1], gammas[2]) >= -limit / problem.shear
    return is_ordered and is_forward and _largest_excess(law, stress, cohesion) <= limit


@beside_kernel
def _apex(law, model, flow, problem, values):
    """Return to the point where all principal stresses are equal."""
    increment = math.sqrt(dot(values, values) / 6.0) / problem.shear
    now = strength(flow, problem, increment)
    target = _apex_stress(law, now.stress)
    limit = allowance(problem, now.stress, mean_stress(model.eos, problem, problem.volume)[1])
    volume, stress, bulk = volume_at(model.eos, problem, target, limit)
    converged = abs(stress - target) <= 10.0 * limit and volume <= problem.volume
    return Returned(
        status_of(converged), APEX, NO_STRESS, volume, stress, bulk, increment, now.variable,
        problem.porosity, 0.0,
    )  # fmt: skip


@inside_kernel
def _apex_stress(law, cohesion):
    """Largest mean stress [Pa]."""
    tangent = math.tan(law.friction_angle * DEGREE)
    return min(law.tension_cutoff, cohesion / tangent if tangent > 0.0 else math.inf)

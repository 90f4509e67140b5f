"""Return to Mohr and Coulomb's surface: to a plane, an edge, a corner or the apex.

At the apex dp is that of the shear or of the volume, dv (3 - sin) / (6 sin) with the sine of the friction angle
(core_models.yield_condition.apex), as on the cone that the pyramid's edges of triaxial compression lie on.
"""

import math

from core_models.compilation import beside_kernel, inside_kernel
from core_models.principal_axes import from_principal, principal
from core_models.status import OK
from core_models.updates.general_problem import (
    NO_STRESS,
    Returned,
    allowance,
    mean_stress,
    return_stress,
    status_of,
    strength,
    unchanged,
)
from core_models.yield_condition.apex import Apex, apex_flow
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

SLACK = 10.0  # of the allowance of a return: how far off order and surface may be


@return_stress.register(MohrCoulomb)
def _(yield_condition, model, flow, problem, rows, k):
    stress, bulk = mean_stress(model.eos, problem, problem.volume)
    values, axes = principal(problem.trial)
    cohesion = strength(flow, problem, 0.0).stress
    if _largest_excess(yield_condition, shifted_values(values, stress), cohesion) <= 0.0:
        return unchanged(problem, stress, bulk)
    # Round-off of the mean stress hides neither order nor direction of the flow, unless nothing else is found.
    returned = _search(yield_condition, model, flow, problem, values, axes, True)
    if returned.status != OK:
        returned = _search(yield_condition, model, flow, problem, values, axes, False)
    return returned


@inside_kernel
def _largest_excess(law, stress, cohesion):
    """How far ordered principal stresses lie beyond the surface [Pa]."""
    return max(excess(law, 0, stress, cohesion), excess(law, 3, stress, cohesion))


@beside_kernel
def _search(law, model, flow, problem, values, axes, is_strict):
    """The first set of active planes whose return ends on the surface with principal stresses in order, or the apex.

    is_strict : whether round-off of the mean stress may not hide the order of the stresses, nor flow backwards.
    """
    for regime in range(1, APEX):
        planes = PLANES[regime - 1]
        if planes[0] >= 3 and law.tension_cutoff == math.inf:
            break
        converged, gammas, now, increment, limit = flow_on(law, model, flow, problem, values, planes)
        cohesion = strength(flow, problem, increment)
        slack = SLACK * limit
        order = allowance(problem, cohesion.stress, abs(now.mean_stress)) if is_strict else slack
        is_on = _largest_excess(law, now.stress, cohesion.stress) <= slack
        if converged and is_on and _is_ordered(problem, gammas, now.stress, order):
            m = now.mean_stress
            deviator = from_principal(shifted_values(now.stress, -m), axes)
            return Returned(
                status_of(True), regime, deviator, now.volume, m, now.bulk, increment, cohesion.variable,
                problem.porosity, 0.0,
            )  # fmt: skip
    return _apex(law, model, flow, problem, values)


@inside_kernel
def _is_ordered(problem, gammas, stress, limit):
    """Whether a return has kept the order of the principal stresses and flowed forwards."""
    is_ordered = stress[0] - stress[1] >= -limit and stress[1] - stress[2] >= -limit
    return is_ordered and min(gammas[0], gammas[1], gammas[2]) >= -limit / problem.shear


@beside_kernel
def _apex(law, model, flow, problem, values):
    """Return to the point where all principal stresses are equal."""
    sheared = math.sqrt(dot(values, values) / 6.0) / problem.shear
    end = apex_flow(apex_of(law), model.eos, flow, problem, sheared)
    return Returned(
        status_of(end.converged and end.volume <= problem.volume), APEX + end.kind, NO_STRESS, end.volume,
        end.mean_stress, end.bulk, end.increment, strength(flow, problem, end.increment).variable,
        problem.porosity, 0.0,
    )  # fmt: skip


@inside_kernel
def apex_of(law):
    """Apex of the pyramid: `Apex`. The edges of triaxial compression grow most: g = 6 sin / (3 - sin)."""
    angle = law.friction_angle * DEGREE
    sine = math.sin(angle)
    return Apex(math.tan(angle), 6.0 * sine / (3.0 - sine), law.tension_cutoff)

"""Flow at the apex of a pressure-dependent surface, where only the mean stress is left beyond the back stress.

With friction f = sigma_y / m there, and g the largest growth of the volume by plastic strain of associated flow on the
rest of the surface:

    m(ln J_e - dv) = min(sigma_y(dp) / f, cut-off)
    dp = max(dp_s, dv / g)   while the cut-off is out of reach; at both, dp in between with sigma_y(dp) = f cut-off

dp_s takes away the shear stress. The volume counts because it is what works there: g is such that sigma_y dp / (m dv)
is that of associated flow beside the apex, which makes dp continuous from there, and the apex as viscous. At the
cut-off alone volume does not count: it does not feel the flow stress.

Source: de Souza Neto, Peric & Owen, Computational Methods for Plasticity (2008), sections 8.2 and 8.3, where
the growth is that of the dilation; that of the friction, here, is defined without dilation too.
"""

from typing import NamedTuple

from core_models.compilation import beside_kernel, inside_kernel
from core_models.updates.general_problem import FARTHEST, allowance, mean_stress, strength, volume_at
from core_models.updates.root import next_guess

MAXIMUM_ITERATIONS = 100
# What the plastic strain is that of: the shear, the volume; or what both give while the cut-off holds the mean stress.
BY_SHEAR, BY_VOLUME, CUT_OFF = 0, 1, 2


class Apex(NamedTuple):
    """friction : flow stress over the mean stress of the apex [-]. growth : of the volume over plastic strain [-].
    cutoff : largest mean stress [Pa].
    """

    friction: float
    growth: float
    cutoff: float


class ApexFlow(NamedTuple):
    """How it ends: converged or not, BY_SHEAR, BY_VOLUME or CUT_OFF, increment of plastic strain, ln J_e, mean stress
    and its slope by ln J_e [Pa].
    """

    converged: bool
    kind: int
    increment: float
    volume: float
    mean_stress: float
    bulk: float


@beside_kernel
def apex_flow(apex, eos, flow, problem, sheared):
    """Flow at the apex: `ApexFlow`.

    Parameters
    ----------
    sheared : increment dp_s of plastic strain that takes away the shear stress [-].
    """
    converged, kind, increment = True, CUT_OFF, sheared
    if strength(flow, problem, sheared).stress <= apex.friction * apex.cutoff:
        converged, kind, increment = _by_volume(apex, eos, flow, problem, sheared)
    if kind == BY_VOLUME:  # a spall cut-off has one mean stress for many volumes
        volume = problem.volume - apex.growth * increment
        stress, bulk = mean_stress(eos, problem, volume)
        return ApexFlow(converged, kind, increment, volume, stress, bulk)
    surface = strength(flow, problem, increment).stress
    target = apex.cutoff if kind == CUT_OFF else surface / apex.friction
    limit = allowance(problem, surface, mean_stress(eos, problem, problem.volume)[1])
    volume, stress, bulk = volume_at(eos, problem, target, limit)
    converged = converged and abs(stress - target) <= 10.0 * limit
    return ApexFlow(converged, kind, increment, volume, stress, bulk)


@beside_kernel
def _by_volume(apex, eos, flow, problem, sheared):
    """Root of f min[m(ln J_e - g dp), cut-off] - sigma_y(dp) above dp_s, where there is one: converged, kind, dp."""
    now = strength(flow, problem, sheared)
    stress, bulk = mean_stress(eos, problem, problem.volume - apex.growth * sheared)
    if apex.friction * min(stress, apex.cutoff) <= now.stress:
        return True, BY_SHEAR, sheared
    limit = allowance(problem, now.stress, bulk)
    low, high = sheared, (problem.volume + FARTHEST) / apex.growth
    increment = (problem.volume - volume_at(eos, problem, now.stress / apex.friction, limit)[0]) / apex.growth
    for _iteration in range(MAXIMUM_ITERATIONS):
        now = strength(flow, problem, increment)
        stress, bulk = mean_stress(eos, problem, problem.volume - apex.growth * increment)
        kind = BY_VOLUME if stress <= apex.cutoff else CUT_OFF
        residual = apex.friction * min(stress, apex.cutoff) - now.stress
        is_near = abs(residual) <= allowance(problem, now.stress, apex.friction * bulk)
        if is_near or high - low <= 1e-15 * high:
            return True, kind, increment
        if residual > 0.0:
            low = increment
        else:
            high = increment
        slope = -now.slope
        if kind == BY_VOLUME:
            slope -= apex.friction * apex.growth * bulk
        increment = next_guess(increment, residual, slope, low, high)
    return False, BY_VOLUME, increment


@inside_kernel
def apex_change(apex, kind, flow, problem, returned, sheared, mean):
    """Change of the mean stress at the apex [Pa].

    Parameters
    ----------
    sheared : change of dp_s. mean : change of the mean stress if the plastic strain stayed [Pa].
    """
    hardening = strength(flow, problem, returned.increment).slope / apex.friction
    if kind == CUT_OFF or hardening == 0.0:
        return 0.0
    if kind == BY_SHEAR:
        return hardening * sheared
    return mean / (1.0 + apex.growth * returned.bulk / hardening)

"""The return of a porous metal to its yield surface: Newton's method, and brackets that always hold the root.

At a given plastic strain of the matrix p, the point where flow is normal to the surface lies between no change of
volume and that which leaves no mean stress; the equality of work then has the opposite sign at p = 0 and at a bound of
p. Both are searched for by bisection where Newton's method does not converge, so that a return takes a bounded number
of steps.
"""

import math

from core_models.compilation import beside_kernel, inside_kernel
from core_models.updates.general_problem import ROUND_OFF, mean_stress, volume_at
from core_models.yield_condition.gurson_flow import (
    WEAKEST,
    flowing,
    matrix_strength,
    porosity_of,
    residual,
    solved,
    voids_before,
    work_over_flow,
)
from core_models.yield_condition.gurson_surface import (
    LARGEST_ARGUMENT,
    argument,
    carrying_share,
    effective_porosity,
    remaining_square,
    yield_function,
)

NEWTON_STEPS = 14
BISECTIONS = 110
TINIEST_VOIDS = 1e-40
SMALLEST_SHARE = 0.1  # of the voids that a Newton step may leave
USUAL_PART = 1e-3  # of the bound, where laws that feel a rate have about the strength that they will have
FEW = 1e-30  # of the bound of the plastic strain, where a bisection of its logarithm begins


@beside_kernel
def search(law, model, flow, problem, mises, elastic_bulk):
    """The plastic flow of a trial outside the surface: converged or not, whether there is any strength, `VoidFlow`."""
    room = problem.volume - volume_at(model.eos, problem, 0.0, ROUND_OFF * elastic_bulk)[0]
    start = voids_before(model.damage, problem, 0.0)[0]
    bound = _largest_increment(law, model, problem, mises, room)
    now = flowing(model, flow, problem, mises, 0.0, start, 0.0)
    whole = matrix_strength(flow, problem, mises / (3.0 * problem.shear) + abs(room)).stress
    if max(now.flow, whole) <= max(WEAKEST, ROUND_OFF * (elastic_bulk + problem.shear)):
        return True, False, now
    guess = _first_guess(law, model, flow, problem, mises, bound)
    has_converged, now = _newton(law, model, flow, problem, mises, room, bound, guess)
    if has_converged:
        return True, True, now
    return _bracketed(law, model, flow, problem, mises, room, bound, guess.increment)


@inside_kernel
def _largest_increment(law, model, problem, mises, room):
    """A bound of the plastic strain of the matrix: the work on the surface, over the least that the matrix may be."""
    closing = voids_before(model.damage, problem, math.inf)[0]
    volume = room if room > 0.0 else min(-room, closing)
    shape = mises / (3.0 * problem.shear)
    return (shape + LARGEST_ARGUMENT / (1.5 * law.q2) * volume) / carrying_share(law, 1.0)[0]


@beside_kernel
def _first_guess(law, model, flow, problem, mises, bound):
    """Flow along the normal at the trial, as much as takes a surface that stays as it is to it."""
    start, _rate = voids_before(model.damage, problem, 0.0)
    stress, bulk = mean_stress(model.eos, problem, problem.volume)
    now = max(
        matrix_strength(flow, problem, 0.0).stress, matrix_strength(flow, problem, USUAL_PART * bound).stress
    )
    f = effective_porosity(law, porosity_of(start))[0]
    x = argument(law, stress, now)
    by_mises = 2.0 * mises / (now * now)
    by_mean = 3.0 * law.q1 * law.q2 * f * math.sinh(x) / now
    outside = max(yield_function(law, mises, stress, now, porosity_of(start)), 0.0)
    stiffness = 3.0 * problem.shear * by_mises * by_mises + bulk * by_mean * by_mean
    steps = outside / stiffness if stiffness > 0.0 else 0.0
    shape, volume = steps * by_mises, steps * by_mean
    work = mises / now * shape + x / (1.5 * law.q2) * volume
    increment = min(work / carrying_share(law, porosity_of(start))[0], bound)
    voids = max(voids_before(model.damage, problem, increment)[0] + volume, 0.0)
    return flowing(model, flow, problem, mises, min(shape, mises / (3.0 * problem.shear)), voids, increment)


@beside_kernel
def _newton(law, model, flow, problem, mises, room, bound, now):
    """Newton's method within the bounds: converged or not, `VoidFlow`."""
    lowest = max(voids_before(model.damage, problem, 0.0)[0] + min(room, 0.0), 0.0)
    highest = voids_before(model.damage, problem, bound)[0] + max(room, 0.0)
    for _step in range(NEWTON_STEPS):
        r = residual(law, now)
        limit = _allowed(problem, now)
        strain = now.shape + abs(now.volume) + now.increment
        if abs(r[0]) <= limit and max(abs(r[1]), abs(r[2])) <= limit * strain:
            return now.volume * room >= 0.0 or abs(now.volume) <= limit * strain, now
        change, is_solved = solved(law, problem, now, r)
        if not is_solved:
            break
        shape = min(max(now.shape - change[0], 0.0), mises / (3.0 * problem.shear))
        voids = max(now.voids - change[1], SMALLEST_SHARE * now.voids)
        increment = min(max(now.increment - change[2], SMALLEST_SHARE * now.increment), bound)
        now = flowing(model, flow, problem, mises, shape, min(max(voids, lowest), highest), increment)
    return False, now


@inside_kernel
def _allowed(problem, now):
    """What may be left of the yield function: the tolerance, and round-off of the elasticity."""
    return problem.tolerance + 10.0 * ROUND_OFF * (now.bulk + problem.shear) / now.flow


@beside_kernel
def _bracketed(law, model, flow, problem, mises, room, bound, increment):
    """Bisection of the plastic strain of the matrix; Newton's method takes over where it finds the root within."""
    low, high = 0.0, bound
    now = flowing(model, flow, problem, mises, 0.0, 0.0, bound)
    for step in range(BISECTIONS):
        if not low < increment < high:
            increment = _between(low, high, bound)
        level = matrix_strength(flow, problem, increment).stress
        start = voids_before(model.damage, problem, increment)[0]
        shape, voids = _normal_flow(law, model, problem, mises, room, level, start)
        now = flowing(model, flow, problem, mises, shape, voids, increment)
        has_converged, settled = _newton(law, model, flow, problem, mises, room, bound, now)
        if has_converged and low <= settled.increment <= high:
            return True, True, settled
        work = work_over_flow(law, now, argument(law, now.mean_stress, now.flow))
        needed = work / carrying_share(law, porosity_of(voids))[0]
        if increment < needed:
            low = increment
        else:
            high = increment
        if high - low <= 4.0 * ROUND_OFF * high:
            break
        increment = needed if step % 2 == 0 else _between(low, high, bound)
    # Inside the surface it ends only where the flow of a law that feels the rate is below round-off.
    return residual(law, now)[0] <= _allowed(problem, now), True, now


@inside_kernel
def _between(low, high, bound):
    """The middle of a bracket, of its logarithm where that is wide."""
    low = max(low, FEW * bound)
    return math.sqrt(low * high) if high > 4.0 * low else 0.5 * (low + high)


@beside_kernel
def _normal_flow(law, model, problem, mises, room, flow, start):
    """Deviatoric strain and voids where flow is normal to the surface, at given flow stress and voids at the start."""
    low = start
    high = start + room if room > 0.0 or start == 0.0 else max(start + room, TINIEST_VOIDS)
    for _bisection in range(BISECTIONS):
        voids = math.sqrt(low * high) if high < 0.25 * low else 0.5 * (low + high)
        if voids in (low, high) or start == 0.0:
            break
        if _is_short(law, model, problem, mises, room, flow, start, voids):
            low = voids
        else:
            high = voids
    high = high if start > 0.0 else 0.0
    return _shape_on_surface(law, model, problem, mises, flow, high - start, high)[0], high


@inside_kernel
def _is_short(law, model, problem, mises, room, flow, start, voids):
    """Whether flow turns normal to the surface nearer to where nothing is left of the mean stress."""
    volume = voids - start
    shape, square, x = _shape_on_surface(law, model, problem, mises, flow, volume, voids)
    across = 3.0 * law.q1 * law.q2 * shape * effective_porosity(law, porosity_of(voids))[0] * math.sinh(x)
    past_normal = 2.0 * volume * math.sqrt(max(square, 0.0)) - across
    return square < 0.0 or (past_normal < 0.0 if room > 0.0 else past_normal > 0.0)


@inside_kernel
def _shape_on_surface(law, model, problem, mises, flow, volume, voids):
    """Deviatoric strain that leads to the surface at a plastic volume, (q / sigma_y)^2 there, and cosh's argument."""
    stress = mean_stress(model.eos, problem, problem.volume - volume)[0]
    square = remaining_square(law, stress, flow, porosity_of(voids))
    shape = max((mises - flow * math.sqrt(max(square, 0.0))) / (3.0 * problem.shear), 0.0)
    return shape, square, argument(law, stress, flow)

"""Return to the yield surface where the elasticity is anisotropic: in the axes of the material, mean stress included.

    x = s - A(dp),   x + lambda C : dev(x) = s_trial - A(dp),   lambda = 3 dp / (2 S),   q(x) = S = sigma_y(dp) + R(dp)

with A what the increment dp of plastic strain leaves of the back stresses and R what it adds to them. For each dp the
tensor equation is linear, so that one equation for dp is left. The flow is that of von Mises' surface; as C does not
keep deviators apart from pressures, it changes the mean stress too.
"""

from typing import NamedTuple

from core_models.compilation import beside_kernel, inside_kernel
from core_models.dispatch import generic
from core_models.elasticity.stiffness import Stiffness, stressed
from core_models.status import OK
from core_models.tensors import (
    congruence,
    contract,
    determinant,
    deviator,
    equivalent_stress,
    inverse,
    minus,
    plus,
    scaled,
    transposed,
)
from core_models.updates.back_stress import move_back_stresses, reach, recovered, recovered_before
from core_models.updates.general_problem import ELASTIC, ROUND_OFF, status_of, strength
from core_models.updates.prediction import NO_STRESS
from core_models.updates.root import next_guess
from core_models.yield_condition.von_mises import VonMises

MAXIMUM_ITERATIONS = 100
PLASTIC = 1  # regime


class AnisotropicProblem(NamedTuple):
    """What a return starts from, tensors in the axes of the material.

    trial : stress (six components) [Pa]. elastic : `Stiffness`. axes : rotation from the axes of the material to space
    after the step. shear : a shear modulus, for first guesses [Pa]. plastic_strain, hardening_variable, temperature [K]
    : before the step. over_dt : 1 / dt [1/s]. tolerance : relative.
    """

    trial: tuple
    elastic: Stiffness
    axes: tuple
    shear: float
    plastic_strain: float
    hardening_variable: float
    temperature: float
    over_dt: float
    tolerance: float


class AnisotropicReturn(NamedTuple):
    """What it ends with: status, regime (ELASTIC or PLASTIC), stress [Pa], direction x / q(x) of the flow, increment
    of equivalent plastic strain, hardening variable, and energy stored beside the elastic one [J/m^3].
    """

    status: int
    regime: int
    stress: tuple
    direction: tuple
    increment: float
    hardening_variable: float
    stored: float


class Trying(NamedTuple):
    """An increment tried: residual, its slope and S [Pa], direction of the flow, stress, hardening variable."""

    residual: float
    surface: float
    slope: float
    direction: tuple
    stress: tuple
    variable: float


@generic
def anisotropic_return(yield_condition, model, flow, problem, rows, k):
    """The stress on or inside the yield surface: `AnisotropicReturn`.

    Parameters
    ----------
    yield_condition : the law. model : all laws. flow : the flow law as it is before the step.
    problem : `AnisotropicProblem`. rows, k : where the back stresses of the point stand, in space.
    """


@generic
def anisotropic_change(yield_condition, model, flow, problem, returned, rows, k, trial):
    """Change of the stress that `anisotropic_return` gives with that of the trial, in the axes of the material."""


@anisotropic_return.register(type(None))
def _(yield_condition, model, flow, problem, rows, k):
    return without_flow(problem)


@anisotropic_change.register(type(None))
def _(yield_condition, model, flow, problem, returned, rows, k, trial):
    return trial


@inside_kernel
def without_flow(problem):
    """The result of an elastic step."""
    return AnisotropicReturn(OK, ELASTIC, problem.trial, NO_STRESS, 0.0, problem.hardening_variable, 0.0)


@anisotropic_return.register(VonMises)
def _(yield_condition, model, flow, problem, rows, k):
    hardening = model.kinematic_hardening
    size = equivalent_stress(deviator(minus(problem.trial, _kept(hardening, problem, 0.0, rows, k)[0])))
    start = strength(flow, problem, 0.0).stress
    if size <= start:
        return without_flow(problem)
    converged, increment, now = _search(
        hardening, flow, problem, (size - start) / (3.0 * problem.shear), rows, k
    )
    direction = congruence(problem.axes, now.direction)
    stored = move_back_stresses(hardening, increment, direction, rows, k) if converged else 0.0
    return AnisotropicReturn(
        status_of(converged), PLASTIC, now.stress, now.direction, increment, now.variable, stored
    )


@beside_kernel
def _search(hardening, flow, problem, guess, rows, k):
    """The increment of plastic strain, whose residual falls with it."""
    low, high = 0.0, guess
    now = _tried(hardening, flow, problem, high, rows, k)
    increment = guess
    for _doubling in range(MAXIMUM_ITERATIONS):
        if now.residual < 0.0:
            break
        low, high = high, 2.0 * high
        now = _tried(hardening, flow, problem, high, rows, k)
    for _iteration in range(MAXIMUM_ITERATIONS):
        now = _tried(hardening, flow, problem, increment, rows, k)
        limit = problem.tolerance * now.surface + ROUND_OFF * problem.shear
        if abs(now.residual) <= limit or high - low <= 1e-15 * high:
            return True, increment, now
        if now.residual > 0.0:
            low = increment
        else:
            high = increment
        increment = next_guess(increment, now.residual, now.slope, low, high)
    return False, increment, now


@inside_kernel
def _tried(hardening, flow, problem, increment, rows, k):
    """What an increment of plastic strain leads to."""
    rest, falling = _kept(hardening, problem, increment, rows, k)
    added, added_slope = reach(hardening, increment)
    now = strength(flow, problem, increment)
    surface, slope = _at_least(now.stress + added, problem), now.slope + added_slope
    softness = 1.5 * increment / surface
    softness_slope = 1.5 * (surface - increment * slope) / (surface * surface)
    x = relaxed(problem.elastic, softness, minus(problem.trial, rest))
    deviatoric = deviator(x)
    size = equivalent_stress(deviatoric)
    direction = scaled(deviatoric, 1.0 / size if size > 0.0 else 0.0)
    flowing = minus(falling, scaled(stressed(problem.elastic, deviatoric), softness_slope))
    size_slope = 1.5 * contract(direction, relaxed(problem.elastic, softness, flowing))
    return Trying(size - surface, surface, size_slope - slope, direction, plus(x, rest), now.variable)


@inside_kernel
def _at_least(stress, problem):
    """S, round-off of the elasticity where the flow law has no strength left, as above its melting temperature."""
    return max(stress, ROUND_OFF * problem.shear)


@inside_kernel
def _kept(hardening, problem, increment, rows, k):
    """What `recovered` (core_models.updates.back_stress) gives, in the axes of the material."""
    total, falling = recovered(hardening, increment, rows, k)
    back = transposed(problem.axes)
    return congruence(back, total), congruence(back, falling)


@inside_kernel
def relaxed(elastic, softness, s):
    """The x of x + softness C : dev(x) = s."""
    c, g = elastic.normal, elastic.shear
    a, b, d = (c[0] + c[3] + c[5]) / 3.0, (c[3] + c[1] + c[4]) / 3.0, (c[5] + c[4] + c[2]) / 3.0
    m = (
        1.0 + softness * (c[0] - a), softness * (c[3] - a), softness * (c[5] - a),
        softness * (c[3] - b), 1.0 + softness * (c[1] - b), softness * (c[4] - b),
        softness * (c[5] - d), softness * (c[4] - d), 1.0 + softness * (c[2] - d),
    )  # fmt: skip
    i = inverse(m, determinant(m))
    return (
        i[0] * s[0] + i[1] * s[1] + i[2] * s[2],
        i[3] * s[0] + i[4] * s[1] + i[5] * s[2],
        i[6] * s[0] + i[7] * s[1] + i[8] * s[2],
        s[3] / (1.0 + 2.0 * softness * g[0]),
        s[4] / (1.0 + 2.0 * softness * g[1]),
        s[5] / (1.0 + 2.0 * softness * g[2]),
    )


@anisotropic_change.register(VonMises)
def _(yield_condition, model, flow, problem, returned, rows, k, trial):
    if returned.regime == ELASTIC:
        return trial
    hardening, increment = model.kinematic_hardening, returned.increment
    direction = congruence(problem.axes, returned.direction)
    falling = congruence(
        transposed(problem.axes), recovered_before(hardening, increment, direction, rows, k)[1]
    )
    added, added_slope = reach(hardening, increment)
    now = strength(flow, problem, increment)
    surface, slope = _at_least(now.stress + added, problem), now.slope + added_slope
    softness = 1.5 * increment / surface
    softness_slope = 1.5 * (surface - increment * slope) / (surface * surface)
    along_flow = scaled(stressed(problem.elastic, returned.direction), softness_slope * surface)
    still = relaxed(problem.elastic, softness, trial)
    flowing = relaxed(problem.elastic, softness, minus(falling, along_flow))
    growth = 1.5 * contract(returned.direction, still)
    growth /= slope - 1.5 * contract(returned.direction, flowing)
    return plus(still, scaled(minus(flowing, falling), growth))

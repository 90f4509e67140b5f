"""Yield condition of porous metals after Gurson, Tvergaard and Needleman."""

import math
from typing import NamedTuple

import numpy as np

from core_models.compilation import beside_kernel, inside_kernel
from core_models.elementary import exponential
from core_models.laws import damage_of_porosity, nucleated
from core_models.tensors import contract, determinant, equivalent_stress, inverse, plus, scaled
from core_models.updates.general_problem import (
    ELASTIC,
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

MAXIMUM_ITERATIONS = 60
BISECTIONS = 40
ATTEMPTS = 20
HALVINGS = 20
OPEN, CLOSED, POWERLESS = 1, 2, 3  # regimes: voids, voids that pressure has closed, a matrix without strength
LARGEST_PART = 0.99  # of the porosity at which nothing carries: what f* is held at, so that a surface remains
LARGEST_ARGUMENT = 30.0  # of cosh


class Gurson(NamedTuple):
    """Gurson-Tvergaard-Needleman: a matrix of flow stress sigma_y with voids of volume fraction f.

        (q / sigma_y)^2 + 2 q1 f* cosh(3 q2 m / (2 sigma_y)) <= 1 + q3 f*^2
        f* = f up to f_c, f_c + k (f - f_c) beyond;   (1 - f) sigma_y d ep = q d e_q + m d v_p
        d f = (1 - f) d v_p + A(ep) d ep

    with associated flow; q is von Mises' stress, m the mean stress, ep the plastic strain of the matrix, e_q the
    deviatoric one of the body, v_p the plastic change of its volume. A is that of the damage law `VoidNucleation`.

    Parameters
    ----------
    q1, q2, q3 : Tvergaard's constants [-], > 0; usually 1.5, 1, q1^2. k : acceleration of the coalescence [-], >= 1.
    f_c : porosity where it begins [-], 0 < f_c < 1.

    Voids that pressure has closed stay closed. f* is held at 99 % of the porosity at which the surface has shrunk to a
    point, where the damage is 1.
    Source: Gurson, J. Eng. Mater. Technol. 99 (1977) 2; Tvergaard & Needleman, Acta Metall. 32 (1984) 157; the unknowns
    of the return: Aravas, Int. J. Numer. Methods Eng. 24 (1987) 1395.
    """

    q1: float
    q2: float
    q3: float
    k: float
    f_c: float

    has_plastic_volume = True

    def fault(self) -> str:
        """What is wrong with the parameters taken together; empty if nothing is."""
        largest = float(full_porosity(self))
        if not self.f_c < largest:
            return f"at f_c = {self.f_c:g} nothing carries any more: give less than {largest:g}"
        return ""


class VoidFlow(NamedTuple):
    """State of the iteration: the unknowns (deviatoric strain, volume, strain of the matrix), von Mises' and the mean
    stress with its slope, flow stress and its slope [Pa], porosity and its slopes by the volume and by the strain of
    the matrix, hardening variable.
    """

    unknowns: tuple
    mises: float
    mean_stress: float
    bulk: float
    flow: float
    hardening: float
    porosity: float
    growth: float
    nucleation: float
    variable: float


@inside_kernel
def full_porosity(law):
    """f* at which the surface has shrunk to a point on the axis of the mean stress, or is the smallest."""
    return (law.q1 - math.sqrt(max(law.q1 * law.q1 - law.q3, 0.0))) / law.q3


@inside_kernel
def accelerated_porosity(law, porosity):
    """f + (k - 1) max(f - f_c, 0), of numbers or arrays."""
    return porosity + (law.k - 1.0) * np.maximum(porosity - law.f_c, 0.0)


@inside_kernel
def effective_porosity(law, porosity):
    """f*, held at its limit, and its slope by f."""
    effective = accelerated_porosity(law, porosity)
    limit = LARGEST_PART * full_porosity(law)
    slope = law.k if porosity > law.f_c else 1.0
    return min(effective, limit), slope if effective < limit else 0.0


@damage_of_porosity.register(Gurson)
def _(yield_condition, porosity, damage):
    largest = LARGEST_PART * full_porosity(yield_condition)
    return np.maximum(damage, np.minimum(accelerated_porosity(yield_condition, porosity) / largest, 1.0))


@inside_kernel
def yield_function(law, mises, stress, flow, porosity):
    """(q / sigma_y)^2 + 2 q1 f* cosh(3 q2 m / (2 sigma_y)) - 1 - q3 f*^2, and the part of it without q."""
    f = effective_porosity(law, porosity)[0]
    rest = 2.0 * law.q1 * f * math.cosh(_argument(law, stress, flow)) - 1.0 - law.q3 * f * f
    return mises * mises / (flow * flow) + rest, rest


@inside_kernel
def _argument(law, stress, flow):
    return min(max(1.5 * law.q2 * stress / flow, -LARGEST_ARGUMENT), LARGEST_ARGUMENT)


@return_stress.register(Gurson)
def _(yield_condition, model, flow, problem, rows, k):
    stress, bulk = mean_stress(model.eos, problem, problem.volume)
    mises = equivalent_stress(problem.trial)
    start = strength(flow, problem, 0.0).stress
    if start > 0.0 and yield_function(yield_condition, mises, stress, start, problem.porosity)[0] <= 0.0:
        return unchanged(problem, stress, bulk)
    return _search(yield_condition, model, flow, problem, mises)


@beside_kernel
def _search(law, model, flow, problem, mises):
    """Newton's method for the three unknowns, from the return at fixed flow stress and porosity."""
    # Laws that feel a rate are stronger than at none: what they have if all of the trial flows is a good start.
    start = strength(flow, problem, 0.0).stress
    start = max(start, min(strength(flow, problem, mises / (3.0 * problem.shear)).stress, mises))
    if not start > 0.0:
        return _powerless(model, problem)
    porosity = problem.porosity
    now = _flowing(law, model, flow, problem, mises, (0.0, 0.0, 0.0))
    unknowns = (0.0, 0.0, 0.0)
    room = problem.volume - volume_at(model.eos, problem, 0.0, problem.tolerance * start)[0]
    has_converged = False
    for _attempt in range(ATTEMPTS):
        shape, volume = _fixed_return(law, model, problem, mises, room, start, porosity)
        work = (mises - 3.0 * problem.shear * shape) * shape
        work += mean_stress(model.eos, problem, problem.volume - volume)[0] * volume
        unknowns = (shape, volume, work / ((1.0 - porosity) * start))
        now = _flowing(law, model, flow, problem, mises, unknowns)
        start, porosity = now.flow, now.porosity
        has_converged, unknowns, now = _newton(law, model, flow, problem, mises, room, unknowns, now)
        if has_converged:
            break
    if not has_converged and mean_stress(model.eos, problem, problem.volume)[0] < 0.0:
        return _closed(law, model, flow, problem, mises)
    factor = now.mises / mises if mises > 0.0 else 1.0
    return Returned(
        status_of(has_converged), OPEN, scaled(problem.trial, factor), problem.volume - unknowns[1],
        now.mean_stress, now.bulk, unknowns[2], now.variable, now.porosity, 0.0,
    )  # fmt: skip


@beside_kernel
def _powerless(model, problem):
    """Return where the matrix has no strength, as above the melting temperature of its flow law: a fluid."""
    stress, bulk = mean_stress(model.eos, problem, problem.volume)
    return Returned(
        status_of(True), POWERLESS, scaled(problem.trial, 0.0), problem.volume, stress, bulk, 0.0,
        problem.hardening_variable, problem.porosity, 0.0,
    )  # fmt: skip


@beside_kernel
def _closed(law, model, flow, problem, mises):
    """Return under a pressure that presses the voids shut: what is left is the matrix, a von Mises solid.

    With the plastic volume v_p = ln(1 - f) of closing, q - 3 G [dp - m v_p / sigma_y(dp)] = sigma_y(dp), by bisection.
    """
    volume = math.log(1.0 - problem.porosity)
    stress, bulk = mean_stress(model.eos, problem, problem.volume - volume)
    start = strength(flow, problem, 0.0)
    low, high = 0.0, mises / problem.shear + stress * volume / start.stress
    increment, now = 0.0, start
    for _bisection in range(2 * MAXIMUM_ITERATIONS):
        increment = 0.5 * (low + high)
        now = strength(flow, problem, increment)
        if mises - 3.0 * problem.shear * (increment - stress * volume / now.stress) > now.stress:
            low = increment
        else:
            high = increment
    is_sheared = increment > stress * volume / now.stress and mises > now.stress
    factor = now.stress / mises if is_sheared else 1.0
    if not is_sheared:
        increment = stress * volume / now.stress
    return Returned(
        status_of(stress <= 0.0), CLOSED, scaled(problem.trial, factor), problem.volume - volume, stress, bulk,
        increment, now.variable, 0.0, 0.0,
    )  # fmt: skip


@beside_kernel
def _fixed_return(law, model, problem, mises, room, flow, porosity):
    """Deviatoric and volume strain of the return at fixed flow stress and porosity, by bisection along the surface."""
    low, high, sign = 0.0, room, 1.0 if room > 0.0 else -1.0
    f = effective_porosity(law, porosity)[0]
    shape, volume = 0.0, 0.0
    for _bisection in range(BISECTIONS):
        volume = 0.5 * (low + high)
        stress = mean_stress(model.eos, problem, problem.volume - volume)[0]
        square = -yield_function(law, 0.0, stress, flow, porosity)[1]
        on_surface = flow * math.sqrt(max(square, 0.0))
        shape = max((mises - on_surface) / (3.0 * problem.shear), 0.0)
        across = 3.0 * law.q1 * law.q2 * shape * f * math.sinh(_argument(law, stress, flow))
        if square < 0.0 or sign * (2.0 * volume * on_surface / flow - across) < 0.0:
            low = volume
        else:
            high = volume
    return shape, volume


@beside_kernel
def _flowing(law, model, flow, problem, mises, unknowns):
    """What some values of the unknowns lead to."""
    shape, volume, increment = unknowns
    now = strength(flow, problem, increment)
    stress, bulk = mean_stress(model.eos, problem, problem.volume - volume)
    grown = (1.0 - problem.porosity) * exponential(-volume)
    added, rate = nucleated(model.damage, problem.plastic_strain, increment)
    porosity = 1.0 - grown + added
    is_empty = porosity <= 0.0
    return VoidFlow(
        unknowns, mises - 3.0 * problem.shear * shape, stress, bulk, now.stress, now.slope, max(porosity, 0.0),
        0.0 if is_empty else grown, 0.0 if is_empty else rate, now.variable,
    )  # fmt: skip


@beside_kernel
def _residual(law, now):
    """Yield function, normality and equality of work, without dimensions."""
    shape, volume, increment = now.unknowns
    f = effective_porosity(law, now.porosity)[0]
    across = 3.0 * law.q1 * law.q2 * shape * f * math.sinh(_argument(law, now.mean_stress, now.flow))
    work = (now.mises * shape + now.mean_stress * volume) / now.flow
    return (
        yield_function(law, now.mises, now.mean_stress, now.flow, now.porosity)[0],
        2.0 * volume * now.mises / now.flow - across,
        increment * (1.0 - now.porosity) - work,
    )


@beside_kernel
def _residual_change(law, now, shape, volume, increment, mises, stress):
    """Change of the residuals with the unknowns, the equivalent and the mean stress."""
    s, v, p = now.unknowns
    f, slope = effective_porosity(law, now.porosity)
    flow, m = now.flow, now.mean_stress
    q = now.mises / flow
    argument = _argument(law, m, flow)
    ch, sh = math.cosh(argument), math.sinh(argument)
    hardened = now.hardening * increment / flow
    voids = now.growth * volume + now.nucleation * increment
    f_change = slope * voids
    turn = 1.5 * law.q2 * (stress - m * hardened) / flow if abs(argument) < LARGEST_ARGUMENT else 0.0
    q_change = mises / flow - q * hardened
    c = 3.0 * law.q1 * law.q2
    work = q * shape + m / flow * volume + q_change * s + (stress - m * hardened) / flow * v
    return (
        2.0 * q * q_change + 2.0 * law.q1 * (ch * f_change + f * sh * turn) - 2.0 * law.q3 * f * f_change,
        2.0 * (q * volume + v * q_change) - c * (f * sh * shape + s * sh * f_change + s * f * ch * turn),
        (1.0 - now.porosity) * increment - p * voids - work,
    )


@inside_kernel
def _matrix(law, problem, now):
    """Slopes of the residuals by the unknowns."""
    a = _residual_change(law, now, 1.0, 0.0, 0.0, -3.0 * problem.shear, 0.0)
    b = _residual_change(law, now, 0.0, 1.0, 0.0, 0.0, -now.bulk)
    c = _residual_change(law, now, 0.0, 0.0, 1.0, 0.0, 0.0)
    return (a[0], b[0], c[0], a[1], b[1], c[1], a[2], b[2], c[2])


@beside_kernel
def _newton(law, model, flow, problem, mises, room, unknowns, now):
    """Newton's method, steps halved where a stress would turn round: converged or not, unknowns, `VoidFlow`."""
    for _iteration in range(MAXIMUM_ITERATIONS):
        r = _residual(law, now)
        strain = abs(unknowns[0]) + abs(unknowns[1]) + unknowns[2]
        limit = 10.0 * allowance(problem, now.flow, now.bulk) / now.flow
        if abs(r[0]) <= limit and max(abs(r[1]), abs(r[2])) <= limit * strain:
            return now.mises >= 0.0 and (now.porosity > 0.0 or problem.porosity == 0.0), unknowns, now
        matrix = _matrix(law, problem, now)
        det = determinant(matrix)
        if det == 0.0 or not math.isfinite(det):
            break
        step = matrix_vector(inverse(matrix, det), r)
        part = 1.0
        for _halving in range(HALVINGS):
            tried = (unknowns[0] - part * step[0], unknowns[1] - part * step[1], unknowns[2] - part * step[2])
            is_possible = tried[2] >= 0.0 and mises - 3.0 * problem.shear * tried[0] >= 0.0
            if is_possible and min(0.0, room) <= tried[1] <= max(0.0, room):
                break
            part *= 0.5
        if part < 1e-5:
            break
        unknowns = (unknowns[0] - part * step[0], unknowns[1] - part * step[1], unknowns[2] - part * step[2])
        now = _flowing(law, model, flow, problem, mises, unknowns)
    return False, unknowns, now


@inside_kernel
def matrix_vector(a, b):
    """Product of a tensor and a vector."""
    return (
        a[0] * b[0] + a[1] * b[1] + a[2] * b[2],
        a[3] * b[0] + a[4] * b[1] + a[5] * b[2],
        a[6] * b[0] + a[7] * b[1] + a[8] * b[2],
    )


@return_change.register(Gurson)
def _(yield_condition, model, flow, problem, returned, rows, k, trial, shear, mean, spin):
    if returned.regime == ELASTIC:
        return trial, mean
    if returned.regime == POWERLESS:
        return scaled(trial, 0.0), mean
    size, mises = equivalent_stress(problem.trial), equivalent_stress(returned.deviator)
    factor = mises / size if size > 0.0 else 1.0
    size_change = 1.5 * contract(problem.trial, trial) / size if size > 0.0 else 0.0
    mises_change, mean_change = size_change, mean
    if returned.regime == OPEN:
        mises_change, mean_change = _open_change(
            yield_condition, model, flow, problem, returned, size, mises, size_change, shear, mean
        )
    elif mises < size:
        mises_change = _closed_change(flow, problem, returned, size_change, shear, mean)
    along = (mises_change - factor * size_change) / size if size > 0.0 else 0.0
    return plus(scaled(trial, factor), scaled(problem.trial, along)), mean_change


@beside_kernel
def _open_change(law, model, flow, problem, returned, size, mises, size_change, shear, mean):
    """Change of the equivalent and the mean stress while there are voids."""
    shape = (size - mises) / (3.0 * problem.shear)
    unknowns = (shape, problem.volume - returned.volume, returned.increment)
    now = _flowing(law, model, flow, problem, size, unknowns)
    bare = size_change - 3.0 * shape * shear
    matrix = _matrix(law, problem, now)
    right = _residual_change(law, now, 0.0, 0.0, 0.0, bare, mean)
    step = matrix_vector(inverse(matrix, determinant(matrix)), right)
    return bare + 3.0 * problem.shear * step[0], mean + now.bulk * step[1]


@inside_kernel
def _closed_change(flow, problem, returned, size_change, shear, mean):
    """Change of the equivalent stress of the matrix."""
    now = strength(flow, problem, returned.increment)
    volume = problem.volume - returned.volume
    pressed = returned.mean_stress * volume / now.stress
    growth = size_change - 3.0 * shear * (returned.increment - pressed)
    growth += 3.0 * problem.shear * volume * mean / now.stress
    return now.slope * growth / (3.0 * problem.shear * (1.0 + pressed * now.slope / now.stress) + now.slope)

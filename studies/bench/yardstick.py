"""A hand-written point update: what the machinery of laws is measured against.

The hypoelastic-plastic update with Johnson-Cook's flow stress, Mie and Grüneisen's equation of state and Taylor and
Quinney's heating, as one writes it for this one material: no laws, no dispatch, no state that a law might ask for, all
formulas in place. It shares the tensor algebra, the incremental rotation and the rows of a block of points.
"""

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from core_models.columns import bring, bring_tensors, take, take_tensors
from core_models.compilation import CHUNK, inside_kernel, kernel
from core_models.elementary import exponential, logarithm, power
from core_models.material import Material
from core_models.points import MaterialPoints
from core_models.quaternions import quaternion, rotation_matrix, rotation_vector, turned
from core_models.rotation import rotation_increment, small_rotation_increment
from core_models.rows import (
    BLOCK,
    ENERGY,
    F0,
    F1,
    PLASTIC_STRAIN,
    ROTATION_0,
    ROTATION_1,
    STRESS,
    TEMPERATURE,
    get,
    get_symmetric,
    get_tensor,
    get_vector,
    make_workspace,
    put,
    put_symmetric,
    put_vector,
)  # fmt: skip
from core_models.state import State
from core_models.tensors import (
    congruence,
    contract,
    determinant,
    deviator,
    equivalent_stress,
    mean,
    minus,
    plus,
    plus_isotropic,
    product_transposed,
    scaled,
    symmetric_inverse,
    symmetric_part,
    symmetric_part_of_product,
)  # fmt: skip

TRIAL, VOLUME_0, VOLUME_1, TRIAL_STRESS, WORK, ALONG, GUESS, FACTOR, INCREMENT, STRENGTH, DONE = (
    41, 47, 48, 49, 50, 51, 52, 53, 54, 55, 56,
)  # fmt: skip
SPEED, STRESS_WORK, DISSIPATION = 57, 58, 59
TOLERANCE = 1e-10
SMALLEST_STRAIN = 1e-12
NEWTON_STEPS = 60


class Constants(NamedTuple):
    """The numbers of the material [SI]."""

    density: float
    shear: float
    C_0: float
    Gamma_0: float
    S_alpha: float
    A: float
    B: float
    C: float
    n: float
    m: float
    epdot_0: float
    T_r: float
    T_m: float
    specific_heat: float
    fraction: float


@inside_kernel
def strength(c, strain, rate, temperature):
    """Flow stress and its slopes by strain and rate."""
    homologous = min(max((temperature - c.T_r) * (1.0 / (c.T_m - c.T_r)), 0.0), 1.0)
    thermal = 1.0 - power(homologous, c.m)
    floored = max(strain, SMALLEST_STRAIN)
    secant = c.B * exponential((c.n - 1.0) * logarithm(floored))
    slope = secant if strain < SMALLEST_STRAIN else c.n * secant
    static = c.A + secant * strain
    rate_factor = 1.0 + c.C * logarithm(max(rate, c.epdot_0) * (1.0 / c.epdot_0))
    by_rate = c.C / max(rate, c.epdot_0) if rate > c.epdot_0 else 0.0
    return static * thermal * rate_factor, slope * thermal * rate_factor, static * thermal * by_rate


@inside_kernel
def residual(c, rows, k, increment, over_dt):
    """Consistency at an increment of plastic strain, its slope, and the flow stress."""
    stress, slope, by_rate = strength(
        c, get(rows, PLASTIC_STRAIN, k) + increment, increment * over_dt, get(rows, TEMPERATURE, k)
    )
    missed = get(rows, TRIAL_STRESS, k) - 3.0 * c.shear * increment - stress
    return missed, -3.0 * c.shear - slope - by_rate * over_dt, stress


@inside_kernel
def put_trial(c, rows, k, r0, v0, u, q):
    """Write the elastic trial of point k."""
    d = scaled(symmetric_part_of_product(minus(u, v0), symmetric_inverse(plus(u, v0))), 2.0)
    s0 = deviator(get_symmetric(rows, STRESS, k))
    trial = plus(s0, scaled(deviator(d), 2.0 * c.shear))
    put_symmetric(rows, TRIAL, k, congruence(rotation_matrix(q), trial))
    put(rows, TRIAL_STRESS, k, equivalent_stress(trial))
    put(rows, WORK, k, contract(s0, d))
    put(rows, ALONG, k, contract(trial, d))
    put(rows, GUESS, k, equivalent_stress(s0))
    put_vector(rows, ROTATION_1, k, rotation_vector(turned(q, r0)))


@inside_kernel
def unrotated(rows, k):
    """Quaternion of R_0, V_0, and F_1 R_0^T of point k."""
    r0 = quaternion(get_vector(rows, ROTATION_0, k))
    r = rotation_matrix(r0)
    v0 = symmetric_part(product_transposed(get_tensor(rows, F0, k), r))
    return r0, v0, product_transposed(get_tensor(rows, F1, k), r)


@inside_kernel
def put_return(rows, k, trial, increment, stress):
    """Write the return of point k."""
    put(rows, FACTOR, k, stress / trial if increment > 0.0 else 1.0)
    put(rows, INCREMENT, k, increment)
    put(rows, STRENGTH, k, stress)


@kernel
def advance_by_hand(
    first, last, workspace, c, f0, f1, dt, volumes, old, new, wave_speed, sums, failures,
):  # fmt: skip
    """Advance the points of chunks first ... last-1: see `advance_points` (core_models.kernels).

    old, new : (stress (n, 6), rotation (n, 3), plastic strain, temperature, energy (n,)). sums : (chunks, 3).
    failures : (chunks,) the first point of each chunk whose state is no number, else -1.
    """
    rows, _statuses = workspace
    over_dt = 1.0 / dt
    for chunk in range(first, last):
        sums[chunk, 0], sums[chunk, 1], sums[chunk, 2], failures[chunk] = 0.0, 0.0, 0.0, -1
        end = min((chunk + 1) * CHUNK, f1.shape[0])
        for start in range(chunk * CHUNK, end, BLOCK):
            count = min(BLOCK, end - start)
            bring_tensors(f0, start, count, rows, F0, 9)
            bring_tensors(f1, start, count, rows, F1, 9)
            bring_tensors(old[0], start, count, rows, STRESS, 6)
            bring_tensors(old[1], start, count, rows, ROTATION_0, 3)
            bring(old[2], start, count, rows, PLASTIC_STRAIN)
            bring(old[3], start, count, rows, TEMPERATURE)
            bring(old[4], start, count, rows, ENERGY)
            trials(c, rows, count)
            returns(c, rows, count, over_dt)
            completions(c, rows, count)
            take_tensors(new[0], start, count, rows, STRESS, 6)
            take_tensors(new[1], start, count, rows, ROTATION_1, 3)
            take(new[2], start, count, rows, PLASTIC_STRAIN)
            take(new[3], start, count, rows, TEMPERATURE)
            take(new[4], start, count, rows, ENERGY)
            take(wave_speed, start, count, rows, SPEED)
            for k in range(count):
                told = get(rows, STRESS_WORK, k) + get(rows, TEMPERATURE, k) + get(rows, PLASTIC_STRAIN, k)
                if failures[chunk] < 0 and not math.isfinite(told + get(rows, SPEED, k)):
                    failures[chunk] = start + k
                sums[chunk, 0] += volumes[start + k] * get(rows, STRESS_WORK, k)
                sums[chunk, 1] += volumes[start + k] * get(rows, DISSIPATION, k)
                sums[chunk, 2] = max(sums[chunk, 2], get(rows, SPEED, k))


@inside_kernel
def trials(c, rows, count):
    """Kinematics and elastic trials."""
    for k in range(count):
        put(rows, VOLUME_0, k, determinant(get_tensor(rows, F0, k)))
        put(rows, VOLUME_1, k, determinant(get_tensor(rows, F1, k)))
        r0, v0, a = unrotated(rows, k)
        q, u, is_right = small_rotation_increment(a)
        put_trial(c, rows, k, r0, v0, u, q)
        is_usual = get(rows, VOLUME_1, k) > 0.0 and c.S_alpha * (1.0 - get(rows, VOLUME_1, k)) < 0.999
        put(rows, DONE, k, 1.0 if is_right and is_usual else 0.0)
    for k in range(count):
        if get(rows, DONE, k) == 0.0:
            r0, v0, a = unrotated(rows, k)
            q, u = rotation_increment(a)
            put_trial(c, rows, k, r0, v0, u, q)


@inside_kernel
def returns(c, rows, count, over_dt):
    """Radial returns: a guess, a Newton step, and more of them where that does not do."""
    for k in range(count):
        guess = max((get(rows, TRIAL_STRESS, k) - get(rows, GUESS, k)) / (3.0 * c.shear), 0.0)
        missed, slope, _stress = residual(c, rows, k, guess, over_dt)
        put(rows, GUESS, k, max(guess - missed / slope, 0.0))
    for k in range(count):
        trial, guess = get(rows, TRIAL_STRESS, k), get(rows, GUESS, k)
        missed, slope, stress = residual(c, rows, k, guess, over_dt)
        is_elastic = guess == 0.0 and missed <= 0.0
        step = 0.0 if is_elastic else -missed / slope
        hardening = -(slope + 3.0 * c.shear) * step
        is_done = abs(hardening * step) <= TOLERANCE * trial * guess and abs(step) < guess
        put_return(rows, k, trial, guess + step, stress + hardening)
        put(rows, DONE, k, 1.0 if is_elastic or is_done else 0.0)
    for k in range(count):
        if get(rows, DONE, k) == 0.0:
            search(c, rows, k, over_dt)


@inside_kernel
def search(c, rows, k, over_dt):
    """The return of a point by Newton steps, in the logarithm where the residual is negative."""
    trial = get(rows, TRIAL_STRESS, k)
    missed, slope, stress = residual(c, rows, k, 0.0, over_dt)
    increment = 0.0
    if missed > 0.0:
        increment = missed / (3.0 * c.shear)
        for _step in range(NEWTON_STEPS):
            missed, slope, stress = residual(c, rows, k, increment, over_dt)
            if abs(missed) <= TOLERANCE * trial:
                break
            step = -missed / slope
            increment = increment + step if missed > 0.0 else increment * math.exp(step / increment)
    put_return(rows, k, trial, increment, stress)


@inside_kernel
def completions(c, rows, count):
    """Pressure with energy, stress and heat."""
    stiffness = c.density * c.C_0 * c.C_0
    for k in range(count):
        before, energy = get_symmetric(rows, STRESS, k), get(rows, ENERGY, k)
        j0, j1 = get(rows, VOLUME_0, k), get(rows, VOLUME_1, k)
        factor, increment = get(rows, FACTOR, k), get(rows, INCREMENT, k)
        factor = 0.0 if get(rows, TEMPERATURE, k) >= c.T_m else factor
        increment = 0.0 if get(rows, TEMPERATURE, k) >= c.T_m else increment
        h = 1.0 - j1
        pole = 1.0 / (1.0 - c.S_alpha * h) if h >= 0.0 else 1.0
        bend = 1.0 - 0.5 * c.Gamma_0 * h if h >= 0.0 else 1.0
        tilt = 1.0 + (c.S_alpha - c.Gamma_0) * h if h >= 0.0 else 1.0
        cold = -(stiffness * h * bend * pole * pole + c.Gamma_0 * energy)
        modulus = max(j1 * (stiffness * tilt * pole * pole * pole - c.Gamma_0 * cold), 0.0)
        change = j1 - j0
        shape = 0.25 * (j0 + j1) * (get(rows, WORK, k) + factor * get(rows, ALONG, k))
        mean_before = mean(before)
        added = shape + 0.5 * mean_before * change
        pressure = (cold - c.Gamma_0 * added) / (1.0 + 0.5 * c.Gamma_0 * change)
        work = shape + 0.5 * (mean_before + pressure) * change
        dissipation = j1 * get(rows, STRENGTH, k) * increment
        heat = c.fraction * dissipation * (1.0 / (c.density * c.specific_heat))
        put_symmetric(
            rows, STRESS, k, plus_isotropic(scaled(get_symmetric(rows, TRIAL, k), factor), pressure)
        )
        put(rows, PLASTIC_STRAIN, k, get(rows, PLASTIC_STRAIN, k) + increment)
        put(rows, TEMPERATURE, k, get(rows, TEMPERATURE, k) + heat)
        put(rows, ENERGY, k, energy + work)
        put(rows, SPEED, k, math.sqrt((modulus + 4.0 / 3.0 * c.shear) * j1 * (1.0 / c.density)))
        put(rows, STRESS_WORK, k, work)
        put(rows, DISSIPATION, k, dissipation)


def constants_of(material: Material) -> Constants:
    """The numbers of a material that has these laws."""
    eos, flow = material.eos, material.flow
    return Constants(
        material.density, material.elasticity.shear_modulus, eos.C_0, eos.Gamma_0, eos.S_alpha, flow.A, flow.B, flow.C,
        flow.n, flow.m, flow.epdot_0, flow.T_r, flow.T_m, material.specific_heat.value, material.heating.fraction,
    )  # fmt: skip


def by_hand(points: MaterialPoints, dt: float) -> Callable[[], None]:
    """A call that advances points of such a material by hand, from their old state to the new one within dt [s]."""
    chunks = -(-points.n // CHUNK)
    workspaces = [make_workspace() for _thread in range(points.threads.count)]
    arguments = (
        constants_of(points.material), points.old_deformation_gradient.reshape(-1, 9),
        points.deformation_gradient.reshape(-1, 9), dt, points.reference_volumes, _fields(points.old),
        _fields(points.new), points.wave_speed, np.zeros((chunks, 3)), np.zeros(chunks, dtype=np.int64),
    )  # fmt: skip
    return lambda: points.threads.run_with(advance_by_hand, chunks, workspaces, *arguments)


def _fields(state: State) -> tuple[np.ndarray, ...]:
    return (
        state.stress, state.rotation, state.equivalent_plastic_strain, state.temperature, state.internal_energy,
    )  # fmt: skip

"""The local problem of a point whose return to the yield surface is not radial, the same in both updates.

From a deviatoric trial stress s and a trial ln J_e of the elastic volume ratio, both in the update's measure (Cauchy
or Kirchhoff), to the stress on the yield surface:

    s_1 = s - 2 G de_p,   m_1 = m(ln J_e - dv_p),   plastic strain increments de_p (deviatoric) and dv_p (volume)
"""

from typing import NamedTuple

from core_models.compilation import beside_kernel, inside_kernel
from core_models.dispatch import generic
from core_models.elementary import exponential
from core_models.laws import evolve_hardening, flow_stress, pressure
from core_models.status import NOT_CONVERGED, OK

STEPS_TO_A_STRESS = 80
FARTHEST = 0.7  # ln J_e within which every mean stress of a solid is looked for
ELASTIC = 0
ROUND_OFF = 1e-15
NO_STRESS = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


class LocalProblem(NamedTuple):
    """What a return starts from.

    trial : deviatoric trial stress (six components) [Pa]. volume : ln J_e of the trial [-]. shear : G [Pa].
    to_measure : the update's measure of stress over Cauchy's.
    energy [J/m^3], plastic_strain, hardening_variable, temperature [K], porosity : before the step.
    over_dt : 1 / dt [1/s]. tolerance : relative.
    """

    trial: tuple
    volume: float
    shear: float
    to_measure: float
    energy: float
    plastic_strain: float
    hardening_variable: float
    temperature: float
    porosity: float
    over_dt: float
    tolerance: float


class Returned(NamedTuple):
    """What it ends with: status, deviatoric stress [Pa], ln J_e, mean stress and its slope by ln J_e [Pa], increment of
    equivalent plastic strain, hardening variable, porosity, and energy stored beside the elastic one [J/m^3].

    regime : which part of the yield surface it lies on, in the law's own numbers; ELASTIC is inside.
    """

    status: int
    regime: int
    deviator: tuple
    volume: float
    mean_stress: float
    bulk: float
    increment: float
    hardening_variable: float
    porosity: float
    stored: float


class Strength(NamedTuple):
    """Flow stress [Pa], its slope by the increment of plastic strain, history variable."""

    stress: float
    slope: float
    variable: float


@generic
def return_stress(yield_condition, model, flow, problem, rows, k):
    """The stress on or inside the yield surface: `Returned`.

    Parameters
    ----------
    yield_condition : the law. model : all laws. flow : the flow law as it is before the step.
    problem : `LocalProblem`. rows, k : where the back stresses of the point stand (core_models.updates.back_stress).
    """


@generic
def return_change(yield_condition, model, flow, problem, returned, rows, k, trial, shear, mean, spin):
    """Change of the deviator (six components) and of the mean stress that `return_stress` gives.

    Parameters
    ----------
    returned : its result, and the rows as it left them. trial, shear : change of those fields of the problem.
    mean : change of the mean stress if the plastic strain stayed. spin : axial vector of the change of rotation dQ Q^T.
    """


@inside_kernel
def mean_stress(eos, problem, volume):
    """Mean stress m [Pa] in the update's measure at ln J_e, and dm / d ln J_e [Pa]."""
    ratio = exponential(volume)
    stress, slope, _by_energy = pressure(eos, ratio, problem.energy)
    return problem.to_measure * stress, problem.to_measure * ratio * slope


@beside_kernel
def volume_at(eos, problem, stress, scale):
    """ln J_e where the mean stress is `stress`, by Newton steps in a bracket; the mean stress there, its slope."""
    low, high = min(-FARTHEST, problem.volume), max(FARTHEST, problem.volume)
    volume = problem.volume
    found, bulk = mean_stress(eos, problem, volume)
    for _step in range(STEPS_TO_A_STRESS):
        if abs(found - stress) <= scale:
            break
        if found < stress:
            low = volume
        else:
            high = volume
        volume = volume - (found - stress) / bulk if bulk > 0.0 else high
        if not low < volume < high:
            volume = 0.5 * (low + high)
        found, bulk = mean_stress(eos, problem, volume)
    return volume, found, bulk


@inside_kernel
def strength(flow, problem, increment):
    """Flow stress after an increment of plastic strain, with the hardening and the rate that go with it."""
    rate = increment * problem.over_dt
    variable, by_increment, variable_rate = evolve_hardening(
        flow, problem.hardening_variable, increment, rate, problem.temperature
    )
    stress, by_variable, by_strain, by_rate, _by_temperature = flow_stress(
        flow, variable, problem.plastic_strain + increment, rate, problem.temperature
    )
    by_variable *= by_increment + variable_rate * problem.over_dt
    return Strength(stress, by_strain + by_rate * problem.over_dt + by_variable, variable)


@inside_kernel
def allowance(problem, stress, bulk):
    """How far from the surface a return may end [Pa]: the tolerance of a stress, and round-off of the elasticity."""
    return problem.tolerance * stress + ROUND_OFF * (bulk + problem.shear)


@inside_kernel
def unchanged(problem, stress, bulk):
    """The result of an elastic step."""
    return Returned(
        OK,
        ELASTIC,
        problem.trial,
        problem.volume,
        stress,
        bulk,
        0.0,
        problem.hardening_variable,
        problem.porosity,
        0.0,
    )


@inside_kernel
def without_deviator(r):
    """The result at a point that has lost its strength: the mean stress alone."""
    return Returned(
        r.status, r.regime, NO_STRESS, r.volume, r.mean_stress, r.bulk, r.increment, r.hardening_variable, r.porosity,
        r.stored,
    )  # fmt: skip


@inside_kernel
def status_of(has_converged):
    """OK or NOT_CONVERGED."""
    return OK if has_converged else NOT_CONVERGED

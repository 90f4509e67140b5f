"""From measured runs to what accuracy costs: errors, observed order, time to reach given errors, Pareto front."""

import math
from dataclasses import dataclass

import numpy as np

from studies.comparisons.convergence import extrapolate
from studies.work_precision.measurement import Measurement
from studies.work_precision.problem import Reference

LEVELS = (0.05, 0.02, 0.01, 0.005, 0.001)
RESOLVABLE = 3.0  # times the reference's own uncertainty: errors below that cannot be told from it
LOWEST_ORDER = 0.3  # of a sequence that is worth extrapolating
FARTHEST = 4.0  # times finer than the finest run, up to which a time is extrapolated

MEASURED, INTERPOLATED, EXTRAPOLATED = "measured", "interpolated", "extrapolated"
NOT_REACHED, NOT_RESOLVABLE = "not reached", "not resolvable"


@dataclass(frozen=True)
class Reach:
    """Seconds to reach an error, and how that is known; None where it is not."""

    seconds: float | None
    how: str


def joint_reference(runs: list[Measurement], quantity: str) -> Reference:
    """A reference from all variants together: the mean of their limits, weighted by 1 / uncertainty^2.

    Its uncertainty is that of the mean or half the spread of those limits, whichever is more, relative to it.
    """
    estimates = []
    for group in by_variant(runs).values():
        if len(group) >= 3:
            estimate = extrapolate([run.resolution for run in group], [run.values[quantity] for run in group])
            estimates.append((estimate.value, max(estimate.uncertainty, 1e-9 * abs(estimate.value))))
    if not estimates:
        return Reference(None, math.inf, "no variant has three runs to extrapolate")
    values, doubts = np.array(estimates).T
    weights = doubts**-2.0
    value = float((weights * values).sum() / weights.sum())
    near = values[doubts <= 10.0 * doubts.min()]
    doubt = max(float(weights.sum() ** -0.5), 0.5 * float(np.ptp(near)))
    return Reference(value, doubt, f"joint extrapolation of {len(estimates)} variants")


def by_variant(runs: list[Measurement]) -> dict[str, list[Measurement]]:
    """Runs that have answers by variant, in the order of the first of each; of a variant coarse to fine."""
    groups: dict[str, list[Measurement]] = {}
    for run in runs:
        if run.values:
            groups.setdefault(run.variant, []).append(run)
    return {name: sorted(group, key=lambda run: run.resolution) for name, group in groups.items()}


def relative_error(run: Measurement, quantity: str, reference: Reference) -> float:
    """Error relative to the reference; the value itself where it is an error already (reference 0)."""
    value = run.values[quantity]
    return abs(value) if reference.value == 0.0 else abs(value / reference.value - 1.0)


def order_of(resolutions: list[int], errors: list[float]) -> float | None:
    """Observed order: slope of log error over log h by least squares; None for fewer than three runs."""
    if len(errors) < 3 or min(errors) <= 0.0:
        return None
    return float(-np.polyfit(np.log(resolutions), np.log(errors), 1)[0])


def observed_order(group: list[Measurement], quantity: str, reference: Reference) -> float | None:
    """Order of a variant's errors; None where there are too few runs, or no reference."""
    if reference.value is None:
        return None
    errors = [relative_error(run, quantity, reference) for run in group]
    return order_of([run.resolution for run in group], errors)


def reach(group: list[Measurement], quantity: str, reference: Reference, level: float) -> Reach:
    """Time for a variant to have an error of at most `level`, and to keep it at all finer resolutions measured."""
    if reference.value is None or level < RESOLVABLE * _uncertainty(reference):
        return Reach(None, NOT_RESOLVABLE)
    errors = [relative_error(run, quantity, reference) for run in group]
    first = len(errors)
    while first > 0 and errors[first - 1] <= level:
        first -= 1
    if first == 0:
        return Reach(group[0].seconds, MEASURED)
    if first < len(errors):
        return Reach(
            _between(group[first - 1 : first + 1], errors[first - 1 : first + 1], level), INTERPOLATED
        )
    return _beyond(group, errors, level)


def _uncertainty(reference: Reference) -> float:
    return reference.uncertainty if reference.value == 0.0 else abs(reference.uncertainty / reference.value)


def _between(pair: list[Measurement], errors: list[float], level: float) -> float:
    """Seconds at an error between two runs, on a line in logarithms; those of the second where it has no error."""
    if errors[1] <= 0.0:
        return pair[1].seconds
    share = math.log(errors[0] / level) / math.log(errors[0] / errors[1])
    return pair[0].seconds * (pair[1].seconds / pair[0].seconds) ** share


def _beyond(group: list[Measurement], errors: list[float], level: float) -> Reach:
    """Seconds at an error below that of the finest run, from the orders of error and time."""
    resolutions = [run.resolution for run in group]
    order = order_of(resolutions, errors)
    if order is None or order < LOWEST_ORDER:
        return Reach(None, NOT_REACHED)
    finer = (errors[-1] / level) ** (1.0 / order)
    if finer > FARTHEST:
        return Reach(None, NOT_REACHED)
    cost = float(np.polyfit(np.log(resolutions), np.log([run.seconds for run in group]), 1)[0])
    return Reach(group[-1].seconds * finer**cost, EXTRAPOLATED)


def pareto_front(runs: list[Measurement], quantity: str, reference: Reference) -> list[Measurement]:
    """Runs that no other run beats in both time and error, fastest first."""
    front: list[Measurement] = []
    best = math.inf
    for run in sorted(runs, key=lambda run: run.seconds):
        error = relative_error(run, quantity, reference) if run.values else math.inf
        if error < best:
            best = error
            front.append(run)
    return front

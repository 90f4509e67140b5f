"""Locking in the classic Taylor bar: every element and interpolation, with and without its cure."""

from meshes.kinds import KINDS
from studies.report.parts import FEM, Table
from studies.verification.outcome import Criterion, Outcome
from studies.verification.problem import Problem
from studies.verification.taylor_bars import BarState, final_state
from studies.verification.variant import Variant, attempt
from studies.verification.variants import cured, uncured

SCENE, WALL = "taylor-classic", "plane"
ACROSS = {
    False: {2: 8, 3: 4},
    True: {2: 4, 3: 4},
}  # linear elements or cells; half as many quadratic elements
LENGTH, RADIUS = 21.42e-3, 7.2256e-3  # m
LENGTH_TOLERANCE, RADIUS_TOLERANCE = 0.006, 0.03
LOCKED = 0.02  # of the radius: by how much a locked element's is less than its cured one's
SMOOTH = 0.25  # roughness of the pressure of a cured element; a checkerboard has about 1


def run(quick: bool) -> Outcome:
    """Two and three dimensions."""
    outcome, rows = Outcome(), []
    for dimension, across in ACROSS[quick].items():
        right, locked = cured(dimension), uncured(dimension)
        done, refused = attempt(
            [*right, *locked],
            lambda variant, across=across: final_state(SCENE, variant, _across(variant, across), WALL),
        )
        rows += [
            _row(v.label, _across(v, across), done[v.label]) for v in [*right, *locked] if v.label in done
        ]
        outcome.criteria += [
            each for v in right if v.label in done for each in _right(v, done[v.label], _across(v, across))
        ]
        for each in refused:
            if each.variant in right:
                what = f"bar, {each.variant.label}"
                outcome.criteria.append(Criterion(what, None, high=0.0, unit="%", reason=each.reason))
            else:
                outcome.remarks.append(f"{each.variant.label} did not get to the end: {each.reason}.")
        outcome.remarks += [_locked(v, done) for v in locked if v.label in done and _cured(v) in done]
    head = (
        "variant",
        "across",
        "length [mm]",
        "radius [mm]",
        "radius off by [%]",
        "plastic strain",
        "roughness",
        "steps",
        "s",
    )
    note = (
        f"Reference: length {1e3 * LENGTH:g} mm, radius {1e3 * RADIUS:g} mm. Roughness: root mean square of the "
        "elements' pressures about their averages round nodes, over the root mean square of the pressure."
    )
    outcome.tables.append(Table("The classic bar at 80 µs", head, tuple(rows), note))
    return outcome


def _across(variant: Variant, linear: int) -> int:
    """Elements or cells on the radius, for the same distance of nodes."""
    return linear // KINDS[variant.kind].degree


def _right(variant: Variant, state: BarState, across: int) -> list[Criterion]:
    name = f"{variant.label}, {across} across"
    found = [
        _near(f"length, {name}", state.length, LENGTH, LENGTH_TOLERANCE),
        _near(f"radius, {name}", state.radius, RADIUS, RADIUS_TOLERANCE),
    ]
    if state.roughness is not None:
        found.append(Criterion(f"roughness of the pressure, {name}", state.roughness, high=SMOOTH))
    return found


def _near(what: str, value: float, reference: float, tolerance: float) -> Criterion:
    off = 100.0 * (value / reference - 1.0)
    return Criterion(what, off, -100.0 * tolerance, 100.0 * tolerance, "%")


def _cured(variant: Variant) -> str:
    """Label of the same variant with its cure."""
    label = variant.label.removesuffix(", no cure")
    return label if variant.method == FEM else f"{label}, mean dilatation"


def _locked(variant: Variant, done: dict[str, BarState]) -> str:
    radius, cured = done[variant.label].radius, done[_cured(variant)].radius
    off = radius / cured - 1.0
    word = "locks" if off < -LOCKED else "does not lock"
    return f"{variant.label} {word}: radius {1e3 * radius:.3f} mm, {100.0 * off:+.1f} % against that with its cure."


def _row(label: str, across: int, state: BarState) -> tuple:
    return (
        label,
        across,
        1e3 * state.length,
        1e3 * state.radius,
        100.0 * (state.radius / RADIUS - 1.0),
        state.plastic_strain,
        state.roughness,
        state.steps,
        state.seconds,
    )


PROBLEM = Problem(
    "taylor-elements",
    "Locking in the classic Taylor bar",
    "Plastic flow keeps the volume, which elements without a cure cannot follow: every element and interpolation with "
    "and without its cure on the bar whose converged answer is known.",
    "Foulk et al. 2021 (converged finite elements)",
    run,
)

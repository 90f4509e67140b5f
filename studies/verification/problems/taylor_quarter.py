"""Taylor bars in three dimensions against the axisymmetric ones."""

from studies.report.parts import FEM, MPM, Table
from studies.verification.outcome import Criterion, Outcome
from studies.verification.problem import Problem
from studies.verification.taylor_bars import BarState, final_state
from studies.verification.variant import Variant, attempt
from studies.verification.variants import EVEN

SCENES = ("taylor-classic", "taylor-copper-jc")
ACROSS = {False: {"FEM": 6, "MPM": 6}, True: {"FEM": 4, "MPM": 6}}
WALL = "plane"
LENGTH_TOLERANCE, RADIUS_TOLERANCE = 0.003, 0.015

PAIRS = {
    "FEM": (Variant("FEM quad4", FEM, "quad4"), Variant("FEM hex8", FEM, "hex8")),
    "MPM": (
        Variant("MPM axisymmetric", MPM, "quad4", EVEN, finer=2),
        Variant("MPM in 3-D", MPM, "hex8", EVEN, finer=2),
    ),
}
"""With half as many particles along the edges of a cell those of the foot, which spread to more than twice their
distance in two directions, sample the stress too coarsely in 3-D."""


def run(quick: bool) -> Outcome:
    """Both scenes, both methods, at one size of element or cell."""
    outcome, rows = Outcome(), []
    for scene in SCENES:
        for method, pair in PAIRS.items():
            across = ACROSS[quick][method]
            done, refused = attempt(
                pair, lambda variant, scene=scene, across=across: final_state(scene, variant, across, WALL)
            )
            rows += [_row(scene, label, across, state) for label, state in done.items()]
            if refused:
                missing = refused[0]
                reason = f"{missing.variant.label}: {missing.reason}"
                outcome.criteria.append(Criterion(f"{method}, {scene}", None, 0.0, 0.0, "%", reason))
                continue
            flat, spatial = done.values()
            outcome.criteria += [
                _criterion(f"length, {method}, {scene}", flat.length, spatial.length, LENGTH_TOLERANCE),
                _criterion(f"radius, {method}, {scene}", flat.radius, spatial.radius, RADIUS_TOLERANCE),
            ]
    head = (
        "bar",
        "across",
        "length [mm]",
        "radius [mm]",
        "largest plastic strain",
        "energy off by [%]",
        "steps",
        "s",
    )
    note = f"Across: elements or cells on the radius; 4 particles along each edge of a cell. Wall {WALL}."
    outcome.tables.append(Table("The bars at their ends", head, tuple(rows), note))
    return outcome


def _criterion(what: str, flat: float, spatial: float, tolerance: float) -> Criterion:
    off = 100.0 * (spatial / flat - 1.0)
    return Criterion(f"{what}: 3-D against axisymmetric", off, -100.0 * tolerance, 100.0 * tolerance, "%")


def _row(scene: str, label: str, across: int, state: BarState) -> tuple:
    return (
        f"{scene}, {label}",
        across,
        1e3 * state.length,
        1e3 * state.radius,
        state.plastic_strain,
        100.0 * state.energy_error,
        state.steps,
        state.seconds,
    )


PROBLEM = Problem(
    "taylor-quarter",
    "Taylor bars in three dimensions",
    "The classic and the copper bar as a quarter in 3-D between two symmetry planes against the axisymmetric bar, at "
    "the same size of elements or cells.",
    "the axisymmetric runs",
    run,
)

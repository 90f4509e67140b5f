"""Locking in Cook's membrane with plastic flow."""

import numpy as np

from core_models.elasticity.isotropic import IsotropicElastic
from core_models.eos.neo_hookean import NeoHookean
from core_models.flow.voce import Voce
from core_models.loads import Damping, Fixed, Traction
from core_models.material import Material
from core_models.updates.hyperelastic_plastic import HyperelasticPlastic
from core_models.yield_condition.von_mises import VonMises
from meshes.cook import cook
from meshes.kinds import KINDS
from meshes.mesh import Mesh
from studies.report.parts import FEM, MPM, Curve, Plot, Table
from studies.verification.outcome import Criterion, Outcome
from studies.verification.problem import Problem
from studies.verification.variant import Variant, attempt, run_until
from studies.verification.variants import cured, uncured

DENSITY, BULK, SHEAR = 7800.0, 164.206e9, 80.1938e9  # E = 206.9 GPa, nu = 0.29
FLOW = Voce(0.45e9, 0.715e9, 16.93, 0.12924e9)
TRACTION = 0.3125e9  # Pa, upwards on the end of 16 mm: 5 kN per mm
PUBLISHED = (6.97e-3, 7.09e-3)  # m, rise of the upper corner of the end
TOLERANCE = 0.03
RAMP, END = 1.2e-3, 2e-3  # s, growth of the force and end; the first elastic period is some 70 µs
DAMPING = (
    1.8e4  # 1/s: with half of it the yielding membrane overshoots by 4 %, with twice it is not at rest at END
)
COUNTS = {
    False: (8, 12, 16),
    True: (8, 12),
}  # linear elements, or cells, on a side; half as many quadratic elements
FINER = {False: (32,), True: ()}  # of linear elements with their cure, which bend stiffly


def body(size: float, kind: str) -> Mesh:
    """The membrane; `size` is that of the cells at the held end."""
    count = round(44e-3 / size)
    return cook([count, count], kind)


def steel() -> Material:
    """The hardening steel of the necking bar."""
    return Material(
        "steel",
        DENSITY,
        HyperelasticPlastic(),
        IsotropicElastic(BULK, SHEAR),
        NeoHookean(BULK),
        FLOW,
        VonMises(),
    )


def rise(variant: Variant, count: int) -> float:
    """Rise of the upper corner of the sheared end [m], at rest."""

    def traction(places: np.ndarray, time: float) -> np.ndarray:
        share = min(time / RAMP, 1.0)
        return np.tile([0.0, TRACTION * share**2 * (3.0 - 2.0 * share)], (len(places), 1))

    solver = variant.solver(
        body,
        steel(),
        44e-3 / (count // KINDS[variant.kind].degree),
        geometry="plane-strain",
        loads=(Fixed("left"), Traction("right", traction), Damping(DAMPING)),
    )
    start = solver.boundary_positions("right")
    corner = int(start[:, 1].argmax())
    run_until(solver, END)
    return float(solver.boundary_positions("right")[corner, 1] - start[corner, 1])


def run(quick: bool) -> Outcome:
    """Every element and interpolation with and without its cure."""
    right, locked = cured(2), uncured(2)
    sizes = {variant.label: COUNTS[quick] for variant in [*right, *locked]}
    sizes |= {v.label: COUNTS[quick] + FINER[quick] for v in right if v.method == FEM and _is_linear(v)}
    done, refused = attempt(
        [*right, *locked], lambda variant: [rise(variant, count) for count in sizes[variant.label]]
    )
    outcome, counts = Outcome(), COUNTS[quick] + FINER[quick]
    for variant in right:
        if variant.label in done:
            off = _outside(done[variant.label][-1])
            outcome.criteria.append(
                Criterion(
                    f"rise, {variant.label}, {sizes[variant.label][-1]} on a side",
                    100.0 * off, -100.0 * TOLERANCE, 100.0 * TOLERANCE, "% outside the published range",
                )
            )  # fmt: skip
    for each in refused:
        if each.variant in right:
            outcome.criteria.append(
                Criterion(f"rise, {each.variant.label}", None, high=0.0, reason=each.reason)
            )
        else:
            outcome.remarks.append(f"{each.variant.label} did not get to the end: {each.reason}.")
    rows = tuple(
        (label, *(1e3 * value for value in values), *[None] * (len(counts) - len(values)))
        for label, values in done.items()
    )
    head = ("variant", *(f"{count} × {count}" for count in counts))
    note = (
        f"Published, converged: {1e3 * PUBLISHED[0]:g} to {1e3 * PUBLISHED[1]:g} mm. Columns: distances of nodes, "
        "or cells of the grid, on a side; quadratic elements are twice as wide."
    )
    outcome.tables.append(Table("Rise of the corner [mm]", head, rows, note))
    outcome.plots = [_plot(done, counts, family) for family in (FEM, MPM)]
    return outcome


def _is_linear(variant: Variant) -> bool:
    return KINDS[variant.kind].degree == 1


def _outside(value: float) -> float:
    """How far a value lies outside the published range, relative to its nearer end."""
    low, high = PUBLISHED
    return value / low - 1.0 if value < low else max(value / high - 1.0, 0.0)


def _plot(done: dict, counts: tuple[int, ...], family: str) -> Plot:
    ends = (counts[0], counts[-1])
    curves = [Curve("published", ends, (1e3 * level, 1e3 * level), "exact") for level in PUBLISHED]
    curves += [
        Curve(label, counts[: len(values)], tuple(1e3 * value for value in values), family)
        for label, values in done.items()
        if label.lower().startswith(family)
    ]
    return Plot(
        f"Cook's membrane, {family.upper()}",
        "distances of nodes, or cells, on a side",
        "rise [mm]",
        tuple(curves),
    )


PROBLEM = Problem(
    "cook-membrane",
    "Cook's membrane with plastic flow",
    "A tapered panel in plane strain, held at one end and sheared at the other far into plastic flow: bending and "
    "constant volume together, on skewed cells. Loaded slowly and damped.",
    "Simo & Armero, Int. J. Num. Meth. Eng. 33 (1992) 1413; Cesar de Sa, Areias & Natal Jorge, ibid. 51 (2001) 883",
    run,
)

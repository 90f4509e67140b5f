"""Criteria, tables and figures of convergence studies: observed orders, ranking at equal time."""

from collections.abc import Iterable, Mapping, Sequence

import numpy as np

from studies.report.parts import FEM, MPM, Curve, Plot, Table
from studies.verification.orders import error_at, fitted_order, sizes_before_floor
from studies.verification.outcome import Criterion, Outcome
from studies.verification.variant import Refused, Variant

VISIBLY = 0.3  # by how much the control's order lies below the lowest that is asked of the others
FLAT = 0.75  # share of the order asked below which a sequence is taken to have reached its floor
Rows = Mapping[str, Sequence]


def convergence_outcome(
    done: Rows, refused: Sequence[Refused], variants: Mapping[str, Variant], control: str
) -> Outcome:
    """Everything about finished sequences of runs (rows of `convergence.ErrorRow`, coarsest first)."""
    criteria = [_order_criterion(variants[label], rows) for label, rows in done.items()]
    criteria += [_missing(each) for each in refused]
    if control in done:
        criteria.append(_control_criterion(control, done[control], variants.values()))
    return Outcome(
        [criterion for criterion in criteria if criterion],
        [_error_table(done), _ranking(done)],
        [_plot(done, variants, family) for family in (FEM, MPM)],
        [f"{each.variant.label} was not run: {each.reason}" for each in refused],
    )


def observed_order(variant: Variant, rows: Sequence) -> tuple[float, int]:
    """Order of the root-mean-square error and the number of sizes that it was fitted to.

    Particles that cross cells sample the stress unevenly, so their error has a floor: only the sizes before it count.
    """
    sizes, errors = [row.size for row in rows], [row.root_mean_square for row in rows]
    used = len(rows)
    if variant.method == MPM:
        used = sizes_before_floor(sizes, errors, FLAT * variant.lowest_order)
    return fitted_order(sizes[:used], errors[:used]), used


def _order_criterion(variant: Variant, rows: Sequence) -> Criterion | None:
    if variant.lowest_order is None:
        return None
    order, used = observed_order(variant, rows)
    which = f"{used} sizes" if used == len(rows) else f"{used} of {len(rows)} sizes, before its floor"
    return Criterion(f"order of {variant.label}, {which}", order, low=variant.lowest_order)


def _missing(refused: Refused) -> Criterion | None:
    variant = refused.variant
    if variant.lowest_order is None:
        return None
    return Criterion(f"order of {variant.label}", None, low=variant.lowest_order, reason=refused.reason)


def _control_criterion(control: str, rows: Sequence, variants: Iterable[Variant]) -> Criterion:
    """The control converges visibly worse over all sizes, or its runs go wrong."""
    asked = min(variant.lowest_order for variant in variants if variant.lowest_order is not None)
    finite = [row for row in rows if row.root_mean_square > 0.0]
    order = (
        fitted_order([row.size for row in finite], [row.root_mean_square for row in finite])
        if finite[1:]
        else 0.0
    )
    wrong = f", {len(rows) - len(finite)} runs went wrong" if len(finite) < len(rows) else ""
    return Criterion(f"order of {control}, visibly lower{wrong}", order, high=asked - VISIBLY)


def _error_table(done: Rows) -> Table:
    sizes = [row.size for row in next(iter(done.values()), [])]
    rows = [
        (
            label,
            *(row.root_mean_square for row in found),
            fitted_order([row.size for row in found], [row.root_mean_square for row in found]),
            found[-1].largest,
            found[-1].steps,
            found[-1].seconds,
        )
        for label, found in done.items()
    ]
    return Table(
        "Root-mean-square displacement error [m]",
        ("variant", *(f"h = {size:.4g} m" for size in sizes), "order", "largest, finest", "steps", "s"),
        tuple(rows),
        "All nodes or all particles at the end; largest error, steps and seconds of stepping at the finest size.",
    )


def _ranking(done: Rows) -> Table:
    """Variants by the error that they reach in equal time, on a polygon through their runs."""
    whole = {label: [row for row in rows if row.root_mean_square > 0.0] for label, rows in done.items()}
    times = {label: [row.seconds for row in rows] for label, rows in whole.items() if rows[1:]}
    if not times:
        return Table("Ranked at equal time", ("variant", "error [m]"), ())
    seconds = float(np.sqrt(max(map(min, times.values())) * min(map(max, times.values()))))
    found = {
        label: error_at(seconds, [row.seconds for row in rows], [row.root_mean_square for row in rows])
        for label, rows in whole.items()
    }
    ranked = sorted((error, label) for label, error in found.items() if error is not None)
    rows = [(label, error, error / ranked[0][0]) for error, label in ranked]
    rows += [(label, None, None) for label, error in found.items() if error is None]
    return Table(
        f"Ranked at equal time: what {seconds:.2g} s of stepping on one core buy",
        ("variant", "error [m]", "times the best"),
        tuple(rows),
        "Interpolated between the runs in log error over log time; a dash: no two runs lie on both sides of that time.",
    )


def _plot(done: Rows, variants: Mapping[str, Variant], family: str) -> Plot:
    curves = [
        Curve(
            label,
            tuple(row.size for row in rows),
            tuple(row.root_mean_square for row in rows),
            family,
        )
        for label, rows in done.items()
        if variants[label].method == family
    ]
    return Plot(
        f"Convergence, {family.upper()}",
        "cell size h [m]",
        "error [m]",
        (*curves, *_slopes(curves)),
        logarithmic=True,
    )


def _slopes(curves: Sequence[Curve]) -> list[Curve]:
    """A line of order 2 below all curves."""
    if not curves:
        return []
    x = np.array(curves[0].x)
    lowest = min(y * (x[0] / size) ** 2 for curve in curves for size, y in zip(curve.x, curve.y, strict=True))
    return [Curve("order 2", tuple(x), tuple(0.7 * lowest * (x / x[0]) ** 2), "exact")]

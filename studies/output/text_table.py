"""A comparison as plain text for the terminal."""

from collections.abc import Iterable, Sequence

from studies.comparisons.comparison import Comparison
from studies.methods.method import find_method
from studies.output.display import (
    ABSENT,
    number,
    plus_minus,
    shown,
    shown_name,
    shown_percent,
    shown_unit,
)


def aligned(rows: Sequence[Sequence[str]]) -> str:
    """Columns under each other: the first to the left, the others to the right."""
    widths = [max(len(cell) for cell in column) for column in zip(*rows, strict=True)]
    lines = (
        "  ".join(
            cell.ljust(w) if i == 0 else cell.rjust(w)
            for i, (cell, w) in enumerate(zip(row, widths, strict=True))
        )
        for row in rows
    )
    return "\n".join(line.rstrip() for line in lines)


def comparison_text(comparison: Comparison) -> str:
    """Quantities, costs and verdicts of a comparison."""
    parts = [f"{comparison.scene.name}, wall {comparison.wall}"]
    if comparison.finest:
        parts += [aligned(list(_quantity_rows(comparison)))]
    parts += [aligned(list(_cost_rows(comparison)))]
    parts += ["\n".join(_verdicts(comparison))]
    return "\n\n".join(part for part in parts if part)


def _quantity_rows(comparison: Comparison) -> Iterable[list[str]]:
    finest = comparison.finest
    apart = {difference.quantity: difference for difference in comparison.differences}
    heads = [[f"{find_method(run.method).label} {run.resolution}", "limit"] for run in finest]
    yield ["quantity", "", *sum(heads, []), "difference", "reference"]
    for name, quantity in finest[0].quantities.items():
        row = [shown_name(name), shown_unit(quantity.unit)]
        for run in finest:
            limit = comparison.limits[run.method].get(name)
            row.append(shown(run.quantities[name].value, quantity.unit))
            row.append(ABSENT if limit is None else plus_minus(limit.value, limit.uncertainty, quantity.unit))
        gap = apart.get(name)
        row.append(shown_percent(None if gap is None else gap.finest_relative))
        row.append(_reference(name, quantity.unit, comparison))
        yield row


def _reference(name: str, unit: str, comparison: Comparison) -> str:
    found = [check.reference for check in comparison.references if check.reference.quantity == name]
    if not found:
        return ""
    low, high = shown(found[0].low, unit), shown(found[0].high, unit)
    return low if low == high else f"{low}-{high}"


def _cost_rows(comparison: Comparison) -> Iterable[list[str]]:
    yield ["run", "status", "points", "steps", "total s", "compile s", "MiB", "energy error"]
    for run in comparison.runs:
        error = run.conservation.get("energy")
        yield [
            run.label,
            run.status,
            str(run.points),
            str(run.cost.steps),
            number(run.cost.wall_s, 3),
            number(run.cost.compile_s, 3),
            f"{run.cost.peak_memory_bytes / 2**20:.0f}",
            ABSENT if error is None else f"{100.0 * error:.3f} %",
        ]


def _verdicts(comparison: Comparison) -> Iterable[str]:
    for difference in comparison.differences[:2]:
        yield difference.verdict
    for run in comparison.failed:
        yield f"{run.label} went wrong: {run.failure}"

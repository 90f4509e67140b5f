"""Quantities and energies of all runs of a comparison, in SI units and with all digits, for CSV files."""

from studies.comparisons.comparison import Comparison
from studies.observers.history import ENERGIES
from studies.report.parts import Table


def quantity_data(comparison: Comparison) -> Table:
    """One row for each quantity of each completed run."""
    rows = [
        (name, quantity.unit, run.method, run.resolution, quantity.value)
        for run in comparison.runs
        for name, quantity in run.quantities.items()
    ]
    rows += [
        (name, comparison.finest[0].quantities[name].unit, method, "limit", limit.value)
        for method, limits in comparison.limits.items()
        for name, limit in limits.items()
    ]
    return Table("Quantities", ("quantity", "unit", "method", "resolution", "value"), tuple(rows))


def energy_data(comparison: Comparison) -> Table:
    """The ledger of each completed run and the errors of its balances."""
    rows = tuple(
        (
            run.method,
            run.resolution,
            *(run.energies[name] for name in (*ENERGIES, "initial")),
            *(run.conservation[name] for name in ("energy", "momentum", "mass")),
        )
        for run in comparison.runs
        if run.failure is None
    )
    errors = ("energy error", "momentum error", "mass error")
    head = ("method", "resolution", *(f"{name} [J]" for name in (*ENERGIES, "initial")), *errors)
    return Table("Energies", head, rows)

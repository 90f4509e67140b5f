"""One run as plain text for the terminal."""

from studies.decisions.afterwards import verified
from studies.decisions.text import verified_text
from studies.observers.fracture_watch import fracture_text
from studies.output.display import shown, shown_name, shown_unit
from studies.output.text_table import aligned
from studies.runs.result import RunResult


def run_text(result: RunResult) -> str:
    """Quantities and cost of a finished run."""
    rows = [
        [
            shown_name(name),
            shown(quantity.value, quantity.unit),
            shown_unit(quantity.unit).ljust(4),
            quantity.note,
        ]
        for name, quantity in result.quantities.items()
    ]
    width = max(len(row[3]) for row in rows)
    table = aligned([[*row[:3], row[3].ljust(width)] for row in rows])
    cost = result.cost
    torn = "" if result.numerical_fracture is None else f"\n{fracture_text(result.numerical_fracture)}"
    error = 100.0 * result.conservation["energy"]
    return (
        f"{result.scene.name}, {result.label}, wall {result.wall}; ended {result.ended}\n\n{table}\n\n"
        f"{result.points} points, {cost.steps} steps, {cost.wall_s:.1f} s in all "
        f"(compilation {cost.compile_s:.1f} s); energy closes to {error:.3f} %{torn}\n\n"
        f"effects, decided from the scene's numbers and verified by the run\n{verified_text(verified(result))}"
    )

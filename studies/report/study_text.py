"""Tables of studies, and what stands in them, as plain text."""

from studies.output.display import ABSENT
from studies.output.text_table import aligned
from studies.report.parts import Cell, Table

DIGITS = 4


def table_text(table: Table) -> str:
    """Title, columns under each other, and the note."""
    rows = [list(table.head), *([shown(cell) for cell in row] for row in table.rows)]
    return "\n".join([table.title, aligned(rows), *([table.note] if table.note else [])])


def shown(value: Cell) -> str:
    """A cell of a table: words as they are, numbers to a few digits."""
    if value is None:
        return ABSENT
    if isinstance(value, str):
        return value
    if isinstance(value, int):
        return f"{value:,}"
    if value == 0.0 or 1e-3 <= abs(value) < 10.0**DIGITS:
        return f"{value:.{DIGITS}g}"
    if abs(value) < 1e6 and abs(value) >= 1.0:
        return f"{value:,.0f}"
    return f"{value:.{DIGITS - 2}e}"

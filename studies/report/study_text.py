"""Tables of studies as plain text for the terminal."""

from studies.output.text_table import aligned
from studies.verification.outcome import Table
from studies.verification.text import shown


def table_text(table: Table) -> str:
    """Title, columns under each other, and the note."""
    rows = [list(table.head), *([shown(cell) for cell in row] for row in table.rows)]
    return "\n".join([table.title, aligned(rows), *([table.note] if table.note else [])])

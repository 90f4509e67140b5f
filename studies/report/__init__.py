"""The report of a comparison: one self-contained HTML page with vector figures that follow light and dark."""

"""Runs side by side: differences, limits of refinement, reference values."""

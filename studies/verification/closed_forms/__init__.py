"""Exact solutions, one per file."""

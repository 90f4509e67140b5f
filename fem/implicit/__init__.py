"""Implicit quasi-static finite elements."""

"""Implicit quasi-static material point method on a grid of B-splines over the reference body."""

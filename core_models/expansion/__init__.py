"""Thermal expansion."""

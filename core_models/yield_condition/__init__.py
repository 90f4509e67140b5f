"""Yield conditions."""

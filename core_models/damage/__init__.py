"""Damage laws."""

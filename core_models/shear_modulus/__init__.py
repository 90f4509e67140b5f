"""Shear modulus laws."""

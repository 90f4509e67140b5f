"""Elasticity laws."""

"""Specific heat laws."""

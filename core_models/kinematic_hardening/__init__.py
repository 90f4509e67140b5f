"""Kinematic hardening laws."""

"""Verification problems, one per file; each gives a `PROBLEM`."""

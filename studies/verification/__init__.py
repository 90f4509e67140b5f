"""Verification: problems with known answers, run by both methods, and a report that says which criteria are met."""

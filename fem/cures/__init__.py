"""Locking cures: one projection of the volume ratio per file, all from a potential."""

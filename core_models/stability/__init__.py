"""Checks of whether the material itself becomes unstable."""

"""Runs that write themselves down as they go, and go on after a kill as if nothing had happened."""

"""Bars and strips that are pulled until they neck: scenes, runs by every method, checks and the report."""

"""What to simulate and what came of it: scenes, runs, quantities, comparison, report, the command `matpoint`."""

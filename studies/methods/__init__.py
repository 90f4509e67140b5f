"""Methods and their variants by name, and ways to slow answers from fast solvers."""

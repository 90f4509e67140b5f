"""Quasi-static equilibrium of any discretised body: Newton's method, increments, linear solvers, convergence log."""

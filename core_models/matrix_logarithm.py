"""Logarithm of matrices near the identity."""

import numpy as np

TERMS = 200
DIVERGENCE = 1e6


def matrix_logarithm(matrices: np.ndarray) -> np.ndarray:
    """Principal logarithm ln A = 2 (Z + Z^3 / 3 + Z^5 / 5 + ...), Z = (A - 1)(A + 1)^-1.

    matrices : (m, 3, 3) that turn by less than 80 degrees and stretch by factors from 1/20 to 20; not-a-number where
    the series does not end.
    Source: Abramowitz & Stegun (1964), 4.1.27, for matrices.
    """
    try:
        z = np.linalg.solve(matrices + np.eye(3), matrices - np.eye(3))
    except np.linalg.LinAlgError:
        return np.full_like(matrices, np.nan)
    square, power, total = z @ z, z, z.copy()
    for k in range(1, TERMS):
        power = power @ square
        term = power / (2 * k + 1)
        total += term
        if not np.abs(power).max() < DIVERGENCE:
            break
        if not np.abs(term).max() > np.finfo(float).eps * np.abs(total).max():
            return 2.0 * total
    return np.full_like(matrices, np.nan)

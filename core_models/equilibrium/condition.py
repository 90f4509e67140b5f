"""Condition number of a sparse stiffness."""

import math

import numpy as np

from core_models.equilibrium.pattern import Pattern


def condition_number(pattern: Pattern, values: np.ndarray) -> float:
    """|K|_1 |K^-1|_1 of the matrix with these values (entries,), an estimate that is seldom too low; inf if singular.

    Source: Higham & Tisseur, SIAM J. Matrix Anal. Appl. 21 (2000) 1185.
    """
    from scipy.sparse import csr_matrix
    from scipy.sparse.linalg import LinearOperator, onenormest, splu

    if not pattern.size:
        return 1.0
    shape = (pattern.size, pattern.size)
    matrix = csr_matrix((values, pattern.columns, pattern.row_starts), shape=shape).tocsc()
    try:
        factors = splu(matrix, permc_spec="MMD_AT_PLUS_A")
    except RuntimeError:
        return math.inf
    inverse = LinearOperator(shape, matvec=factors.solve, rmatvec=lambda b: factors.solve(b, trans="T"))
    # The estimate starts from random columns: one column makes it the same every time.
    return float(abs(matrix).sum(axis=0).max() * onenormest(inverse, t=1))

"""The lowest natural frequency of a body on its supports."""

import numpy as np

from core_models.equilibrium.pattern import Pattern


def lowest_frequency(pattern: Pattern, stiffness: list[np.ndarray], masses: np.ndarray) -> float:
    """Lowest angular frequency [rad/s]: K x = w^2 M x.

    pattern, stiffness : of the free degrees of freedom and its blocks [N/m]. masses : lumped, of these (n,) [kg].
    """
    from scipy.sparse import csr_array, diags_array
    from scipy.sparse.linalg import eigsh

    shape = (pattern.size, pattern.size)
    matrix = csr_array((pattern.assemble(stiffness), pattern.columns, pattern.row_starts), shape=shape)
    scale = diags_array(1.0 / np.sqrt(masses))
    symmetric = (scale @ (0.5 * (matrix + matrix.T)) @ scale).tocsc()
    # ARPACK starts from random numbers unless told where: results are to be the same every time.
    start = np.ones(pattern.size)
    return float(np.sqrt(eigsh(symmetric, k=1, sigma=0.0, v0=start, return_eigenvectors=False)[0]))

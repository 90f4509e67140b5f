"""Shape functions of all kinds of element, as array functions of reference coordinates."""

from functools import cache

import numpy as np

from meshes.kinds import KINDS, monomials


def shape_values(name: str, places: np.ndarray) -> np.ndarray:
    """N_a at reference coordinates (q, d): (q, nodes), in VTK's order of nodes."""
    return _powers(monomials(name), places) @ _coefficients(name)


def shape_gradients(name: str, places: np.ndarray) -> np.ndarray:
    """dN_a/dxi_k at reference coordinates (q, d): (q, nodes, d)."""
    exponents = monomials(name)
    columns = []
    for k in range(exponents.shape[1]):
        lower = exponents.copy()
        lower[:, k] = np.maximum(lower[:, k] - 1, 0)
        columns.append((_powers(lower, places) * exponents[:, k]) @ _coefficients(name))
    return np.stack(columns, axis=2)


def _powers(exponents: np.ndarray, places: np.ndarray) -> np.ndarray:
    return np.prod(np.asarray(places, dtype=float)[:, None, :] ** exponents[None], axis=2)


@cache
def _coefficients(name: str) -> np.ndarray:
    """Column a: coefficients of N_a; whole numbers, since the nodes lie at 0, 1/2 and 1."""
    return np.rint(np.linalg.inv(_powers(monomials(name), KINDS[name].reference_nodes)))

"""Linear dilatation: the volume ratio of an element is its best linear approximation (Q2/P1 for quadratic ones)."""

from typing import NamedTuple

import numpy as np

from fem.cures.projection import PROJECTED, project
from fem.elements import points_of


class LinearDilatation(NamedTuple):
    """theta_q = (1 - share) sum_r b_r(q) sum_k w_k b_r(k) J_k + share J_q with b orthonormal and spanning {1, X}.

    basis : (m, q, r) b_r at the points, sum_q w_q b_r b_s = 1 for r = s, else 0 [m^-3/2].
    """

    basis: np.ndarray
    share: float


def linear_dilatation(places: np.ndarray, weights: np.ndarray, share: float) -> LinearDilatation:
    """The projection for points at reference positions (m, q, d) [m] with reference volumes (m, q) [m^3].

    share : of its own volume ratio that a point keeps.
    """
    centre = np.einsum("eq,eqi->ei", weights, places) / weights.sum(axis=1, keepdims=True)
    away = places - centre[:, None]
    size = np.sqrt((away**2).sum(axis=2).mean(axis=1))
    functions = np.concatenate([np.ones((*weights.shape, 1)), away / size[:, None, None]], axis=2)
    root = np.sqrt(weights)[..., None]
    return LinearDilatation(np.ascontiguousarray(np.linalg.qr(root * functions)[0] / root), share)


@project.register(LinearDilatation)
def _(cure, element, tables, e, scratch, column):
    for q in range(points_of(element)):
        scratch[q, PROJECTED + column] = cure.share * scratch[q, column]
    for r in range(cure.basis.shape[2]):
        part = 0.0
        for q in range(points_of(element)):
            part += tables.weights[e, q] * cure.basis[e, q, r] * scratch[q, column]
        for q in range(points_of(element)):
            scratch[q, PROJECTED + column] += (1.0 - cure.share) * part * cure.basis[e, q, r]

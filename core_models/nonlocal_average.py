"""Nonlocal damage: growth of the damage variable or of the porosity, averaged over a neighbourhood of the body."""

from typing import Any

import numpy as np


def bell_weights(positions: np.ndarray, volumes: np.ndarray, radius: float) -> Any:
    """Weights of the average at each point over its neighbours, a sparse array (n, n) of scipy whose rows sum up to 1.

        w_ij = V_j alpha(|X_i - X_j|) / sum_k V_k alpha(|X_i - X_k|),   alpha(r) = (1 - r^2 / R^2)^2 for r < R

    Parameters
    ----------
    positions : (n, d) in the reference body [m]; in axisymmetry those in the plane of r and z, so that a neighbourhood
    is a ring. volumes : (n,) [m^3]. radius : R [m], > 0.

    A field that is constant stays what it is, bit for bit to round-off, at the surface as well. Neighbours are found
    through gaps and between bodies that lie closer than R.
    Source: Bažant & Jirásek, J. Eng. Mech. 128 (2002) 1119, eqs. 1, 2 and 12.
    """
    # Here, not above: the laws need nothing but numpy and numba.
    from scipy.sparse import coo_array
    from scipy.spatial import cKDTree

    pairs = cKDTree(positions).query_pairs(radius, output_type="ndarray")
    distances = np.linalg.norm(positions[pairs[:, 0]] - positions[pairs[:, 1]], axis=1)
    bells = (1.0 - (distances / radius) ** 2) ** 2
    own = np.arange(len(positions))
    rows = np.r_[own, pairs[:, 0], pairs[:, 1]]
    columns = np.r_[own, pairs[:, 1], pairs[:, 0]]
    weights = coo_array((np.r_[np.ones(len(own)), bells, bells] * volumes[columns], (rows, columns))).tocsr()
    weights.data /= np.repeat(weights.sum(axis=1), np.diff(weights.indptr))
    return weights


class NonlocalAverage:
    """What damages a body, grown with the average of its growth all around.

        x_i <- max(x_i + sum_j w_ij (x_j - x_j,before), 0)   for points that take part

    Parameters
    ----------
    positions, volumes, radius : see `bell_weights`.

    x is the damage variable, or the porosity of a porous metal. Failed points (D >= 1 before the step) do not take
    part: neither do they give, nor does what they have change.
    """

    def __init__(self, positions: np.ndarray, volumes: np.ndarray, radius: float) -> None:
        self.weights = bell_weights(positions, volumes, radius)

    def apply(self, before: np.ndarray, after: np.ndarray, takes_part: np.ndarray) -> None:
        """Replace what a step has added to a variable (n,) by its average, in `after`.

        takes_part : (n,) truth values.
        """
        growth = self.weights @ np.where(takes_part, after - before, 0.0)
        after[takes_part] = np.maximum(before[takes_part] + growth[takes_part], 0.0)

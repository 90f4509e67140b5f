"""Drucker's stability postulate."""

from typing import NamedTuple

import numpy as np

from core_models.laws import stability_measure


class DruckerStability(NamedTuple):
    """Drucker's stability postulate: second-order work of every stretching D is positive.

        min over D of  D : C : D / (2 G D : D)  > 0,   (Kirchhoff stress, Jaumann's rate) / J = C : D

    with the tangent C of continued flow. With von Mises' surface the measure is about H / (3 G + H): it is lost where
    the flow stress, heat included, stops to rise.

    Source: Drucker, Proc. 1st US Natl. Congr. Appl. Mech. (1951) 487; Hill, J. Mech. Phys. Solids 6 (1958) 236.
    """


PAIRS = ((0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0))
WEIGHTS = np.sqrt([1.0, 1.0, 1.0, 2.0, 2.0, 2.0])  # Mandel's: the six components keep the norm of a tensor


@stability_measure.register(DruckerStability)
def _(stability, tangents, stresses, bulk_modulus, shear_modulus):
    one = np.eye(3)
    corner = np.einsum("ik,njl->nijkl", one, stresses)
    # From the nominal rate, sigma_jl l_ik apart, to Truesdell's and then to Jaumann's rate.
    rate = tangents - corner
    rate += 0.5 * sum(corner.transpose(order) for order in ORDERS)
    first, second = zip(*PAIRS, strict=True)
    matrix = _symmetric(rate)[:, first, second][:, :, first, second] * WEIGHTS[:, None] * WEIGHTS
    matrix = 0.5 * (matrix + matrix.transpose(0, 2, 1))
    return np.linalg.eigvalsh(matrix)[:, 0] / (2.0 * shear_modulus)


ORDERS = ((0, 1, 2, 3, 4), (0, 2, 1, 3, 4), (0, 1, 2, 4, 3), (0, 2, 1, 4, 3))  # i and j, k and l exchanged


def _symmetric(tensors: np.ndarray) -> np.ndarray:
    """The part that is symmetric in the first pair and in the last pair of indices."""
    return 0.25 * sum(tensors.transpose(order) for order in ORDERS)

"""Loss of hyperbolicity."""

from typing import NamedTuple

import numpy as np

from core_models.laws import stability_measure


class HyperbolicityLoss(NamedTuple):
    """Loss of hyperbolicity: a plane across which the velocity gradient may jump, so that a band can form.

        min over n of  det Q / [(K + 4 G / 3) G^2]  > 0,   Q_ik = n_j a_ijkl n_l

    with the acoustic tensor Q of continued flow, heat of the plastic work included, K and G those of the body at rest.
    With von Mises' surface and small strains it is lost at the hardening modulus H = -3 G (1 + nu) N^2 / 2, where N is
    the middle principal deviator over |s| / sqrt(2): at H = 0 in shear, later in tension.

    The minimum is looked for from 200 directions, and then to some 1e-4 of an angle.
    Source: Rice, in Koiter (ed.), Theoretical and Applied Mechanics (1976) 207; Rudnicki & Rice, J. Mech. Phys. Solids
    23 (1975) 371; Becker, Int. J. Solids Struct. 39 (2002) 3555.
    """


DIRECTIONS = 200
REFINEMENTS = 16
FIRST_STEP = 0.1  # rad
GOLDEN_ANGLE = np.pi * (3.0 - np.sqrt(5.0))
BLOCK = 2000  # points at a time, to limit the memory


@stability_measure.register(HyperbolicityLoss)
def _(stability, tangents, stresses, bulk_modulus, shear_modulus):
    scale = (bulk_modulus + 4.0 / 3.0 * shear_modulus) * shear_modulus**2
    blocks = [_smallest(tangents[k : k + BLOCK]) for k in range(0, len(tangents), BLOCK)]
    return np.concatenate(blocks) / scale if blocks else np.empty(0)


def _smallest(tangents: np.ndarray) -> np.ndarray:
    """The smallest determinant of the acoustic tensors of points, (n,)."""
    angles = np.broadcast_to(_hemisphere(), (len(tangents), DIRECTIONS, 2))
    best, found = _best(tangents, angles)
    step = FIRST_STEP
    around = np.array([(i, j) for i in (-1, 0, 1) for j in (-1, 0, 1)], dtype=float)
    for _refinement in range(REFINEMENTS):
        best, found = _best(tangents, best[:, None] + step * around)
        step *= 0.65
    return found


def _best(tangents: np.ndarray, angles: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Of directions (n, m, 2) for each point those with the smallest determinant, (n, 2), and that (n,)."""
    polar, around = angles[..., 0], angles[..., 1]
    normals = np.stack(
        [np.sin(polar) * np.cos(around), np.sin(polar) * np.sin(around), np.cos(polar)], axis=-1
    )
    acoustic = np.einsum("nmj,nijkl,nml->nmik", normals, tangents, normals)
    determinants = np.linalg.det(acoustic)
    chosen = determinants.argmin(axis=1)
    rows = np.arange(len(chosen))
    return angles[rows, chosen], determinants[rows, chosen]


def _hemisphere() -> np.ndarray:
    """Polar angles and angles around, evenly over half a sphere (Fibonacci's lattice)."""
    k = np.arange(DIRECTIONS)
    return np.stack([np.arccos((k + 0.5) / DIRECTIONS), k * GOLDEN_ANGLE], axis=-1)

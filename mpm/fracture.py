"""Numerical fracture: neighbours in the reference body that no longer share a node of the grid.

A particle at x acts on the nodes within its support, |x_i - x| < S h along every axis:

    S = 1 (linear), 3/2 (quadratic), 2 (cubic), 1 + half the particle's size (GIMP), of its deformed domain (CPDI)

Two particles whose domains have a face in common in the reference body hold together through the nodes that both act
on. Stretched so far apart that there is none left, they part without any physics of fracture. In the total
configuration supports are those of the reference body, so this cannot happen; nor do convected domains part.
Source: de Vaucorbeil, Nguyen & Hutchinson, Comput. Methods Appl. Mech. Eng. 360 (2020) 112783.
"""

from typing import NamedTuple

import numpy as np

from mpm.interpolation.catalogue import Interpolation
from mpm.interpolation.cpdi import ConvectedDomain, extents
from mpm.interpolation.cubic import CubicSpline
from mpm.interpolation.gimp import UniformGimp
from mpm.interpolation.linear import LinearHat
from mpm.interpolation.quadratic import QuadraticSpline

SUPPORTS = {LinearHat: 1.0, QuadraticSpline: 1.5, CubicSpline: 2.0}
FACES = {
    2: ((0, 1), (1, 2), (2, 3), (3, 0)),
    3: ((0, 1, 2, 3), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)),
}
"""Corners of the faces of a domain, VTK order, by dimension."""
FINENESS = 2**20  # places along the body's size that faces are told apart by
SHIFT = (
    0.32  # of such a place: faces in the planes of a regular mesh are then far from where rounding decides
)


class Fracture(NamedTuple):
    """Pairs of neighbours that have come apart; of the widest one the middle [m], and how often its length in the
    reference body it is long.
    """

    pairs: int
    position: tuple[float, ...]
    stretch: float


def neighbours(corners: np.ndarray) -> np.ndarray:
    """Pairs (k, 2) of particles whose domains with corners (n, 2^d, d) [m] have a face in common."""
    d = corners.shape[2]
    low = corners.min(axis=(0, 1))
    unit = float(np.ptp(corners, axis=(0, 1)).max()) / (FINENESS - 1)
    keys = np.zeros((len(corners), len(FACES[d])), dtype=np.int64)
    for number, face in enumerate(FACES[d]):
        places = np.floor((corners[:, face].mean(axis=1) - low) / unit + SHIFT).astype(np.int64)
        for axis in range(d):
            keys[:, number] += places[:, axis] * FINENESS**axis
    order = np.argsort(keys, axis=None, kind="stable")
    same = np.flatnonzero(np.diff(keys.ravel()[order]) == 0)
    owners = order // len(FACES[d])
    pairs = np.stack([owners[same], owners[same + 1]], axis=1)
    return np.unique(np.sort(pairs[pairs[:, 0] != pairs[:, 1]], axis=1), axis=0)


def supports(shape: Interpolation, cell_size: float) -> np.ndarray | float:
    """S of the particles along the axes (n, d) [cells], or of all of them."""
    if isinstance(shape, UniformGimp):
        return 1.0 + shape.halves / cell_size
    if isinstance(shape, ConvectedDomain):
        return 1.0 + 0.5 * extents(shape) / cell_size
    return SUPPORTS[type(shape)]


class Neighbours:
    """Pairs of particles that belong together.

    Parameters
    ----------
    corners : of the particles' domains in the reference body (n, 2^d, d) [m]. reference : their positions (n, d) [m].
    """

    def __init__(self, corners: np.ndarray, reference: np.ndarray) -> None:
        self._pairs = neighbours(corners)
        self._lengths = np.linalg.norm(np.diff(reference[self._pairs], axis=1)[:, 0], axis=1)

    def parted(
        self,
        positions: np.ndarray,
        base: np.ndarray,
        cell_size: float,
        reach: np.ndarray | float,
        intact: np.ndarray,
    ) -> Fracture | None:
        """The pairs of intact particles that share no node, if there are any.

        positions (n, d) [m]. base (d,) : what nodes are counted from [m]. reach : `supports`. intact (n,) : bool.
        """
        places = (positions - base) / cell_size - 0.5
        first, last = np.floor(places - reach) + 1.0, np.ceil(places + reach) - 1.0
        one, other = self._pairs.T
        apart = (np.maximum(first[one], first[other]) > np.minimum(last[one], last[other])).any(axis=1)
        found = np.flatnonzero(apart & intact[one] & intact[other])
        if not found.size:
            return None
        ends = positions[self._pairs[found]]
        lengths = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
        widest = int(lengths.argmax())
        middle = ends[widest].mean(axis=0)
        return Fracture(
            len(found), tuple(float(x) for x in middle), float(lengths[widest] / self._lengths[found[widest]])
        )

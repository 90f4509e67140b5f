"""Nonlocal damage: growth of the damage variable or of the porosity, averaged over a neighbourhood of the body."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from core_models.geometry import Axisymmetric, Geometry, PlaneStrain, Spatial
from core_models.mirror_images import Plane, mirror_images

SPATIAL = Spatial()
ANGLES = 12  # Gauss points over the part of a circle that lies within the ball


def bell_weights(
    positions: np.ndarray,
    volumes: np.ndarray,
    radius: float,
    geometry: Geometry = SPATIAL,
    planes: Sequence[Plane] = (),
) -> Any:
    """Weights of the average at each point over a ball of the body, a sparse array (n, n) of scipy; rows sum up to 1.

        w_ij = V_j alpha_ij / sum_k V_k alpha_ik,   alpha = (1 - |X_i - X_j|^2 / R^2)^2 within the ball

    In axisymmetry alpha is the mean over the circle that point j stands for, in plane strain the integral along the
    line; across symmetry planes the images of j count as well.

    Parameters
    ----------
    positions : (n, d) in the reference body [m]. volumes : (n,) [m^3]. radius : R [m], > 0. geometry : of the
    coordinates. planes : of symmetry.

    A field that is constant stays what it is, bit for bit to round-off, at the surface as well. Neighbours are found
    through gaps and between bodies that lie closer than R.
    Source: Bažant & Jirásek, J. Eng. Mech. 128 (2002) 1119, eqs. 1, 2 and 12.
    """
    # Here, not above: the laws need nothing but numpy and numba.
    from scipy.sparse import coo_array
    from scipy.spatial import cKDTree

    images, owners = mirror_images(positions, planes, radius)
    pairs = cKDTree(positions).sparse_distance_matrix(cKDTree(images), radius, output_type="ndarray")
    rows, columns = pairs["i"], owners[pairs["j"]]
    share = 1.0 - (pairs["v"] / radius) ** 2
    if isinstance(geometry, Axisymmetric):
        bells = circle_mean(share, 4.0 * positions[rows, 0] * positions[columns, 0] / radius**2)
    else:
        bells = share ** (2.5 if isinstance(geometry, PlaneStrain) else 2.0)
    weights = coo_array((bells * volumes[columns], (rows, columns)), shape=2 * (len(positions),)).tocsr()
    weights.data /= np.repeat(weights.sum(axis=1), np.diff(weights.indptr))
    return weights


def circle_mean(share: np.ndarray, turn: np.ndarray) -> np.ndarray:
    """Mean of the bell over a circle round the axis, (n,).

        2 / pi int_0^p (a - b sin^2 phi)^2 d phi,   sin^2 p = min(a / b, 1)

    Parameters
    ----------
    share : a = 1 - (distance in the plane of r and z)^2 / R^2, >= 0. turn : b = 4 r_i r_j / R^2, >= 0.
    """
    nodes, weights = np.polynomial.legendre.leggauss(ANGLES)
    end = np.arcsin(np.sqrt(share / np.maximum(np.maximum(turn, share), np.finfo(float).tiny)))
    total = np.zeros_like(share)
    for node, weight in zip(nodes, weights, strict=True):
        total += weight * (share - turn * np.sin(0.5 * (1.0 + node) * end) ** 2) ** 2
    return total * end / np.pi


class NonlocalAverage:
    """What damages a body, grown with the average of its growth all around.

        x_i <- max(x_i + sum_j w_ij (x_j - x_j,before), 0)   for points that take part

    Parameters
    ----------
    positions, volumes, radius, geometry, planes : see `bell_weights`.

    x is the damage variable, or the porosity of a porous metal. Failed points (D >= 1 before the step) do not take
    part: neither do they give, nor does what they have change.
    """

    def __init__(
        self,
        positions: np.ndarray,
        volumes: np.ndarray,
        radius: float,
        geometry: Geometry = SPATIAL,
        planes: Sequence[Plane] = (),
    ) -> None:
        self.weights = bell_weights(positions, volumes, radius, geometry, planes)

    def apply(self, before: np.ndarray, after: np.ndarray, takes_part: np.ndarray) -> None:
        """Replace what a step has added to a variable (n,) by its average, in `after`.

        takes_part : (n,) truth values.
        """
        growth = self.weights @ np.where(takes_part, after - before, 0.0)
        after[takes_part] = np.maximum(before[takes_part] + growth[takes_part], 0.0)

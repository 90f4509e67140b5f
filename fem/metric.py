"""What the estimate of the stable step needs of the reference body: see `fem.stable_step`."""

from typing import NamedTuple

import numpy as np

from core_models.geometry import Axisymmetric, Geometry
from fem.tables import Tables

COMPONENTS = ((0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0))
EVENING_ROUNDS = 4
AT_ONCE = 2048  # elements: what is worked on at a time stays in the cache


class Metric(NamedTuple):
    """tensors : (m, q, 6) H in the order 11, 22, 33, 12, 23, 31 [1/(kg m^-1)]; free : (n,) 0 for a node on the axis,
    whose radius is fixed, else 1; hourglass : (m,) square of the largest frequency of hourglass control [1/s^2].
    """

    tensors: np.ndarray
    free: np.ndarray
    hourglass: np.ndarray | None


def make_metric(
    tables: Tables,
    corner_mass: np.ndarray,
    geometry: Geometry,
    points: np.ndarray,
    hourglass: np.ndarray | None,
) -> Metric:
    """The metric of a space. points : (n, d) reference positions of the nodes [m]."""
    is_axisymmetric = isinstance(geometry, Axisymmetric)
    free = (points[:, 0] > 0.0).astype(np.float64) if is_axisymmetric else np.ones(len(points))
    tensors = np.empty((*tables.weights.shape, 6))
    for first in range(0, len(tensors), AT_ONCE):
        some = slice(first, first + AT_ONCE)
        gradients = tables.gradients[some].copy()
        if is_axisymmetric:
            gradients[..., 2] *= free[tables.nodes[some]][:, None]
        share = _shares(tables.weights[some], gradients, corner_mass[some])
        tensors[some] = _symmetric(tables.weights[some], gradients, share)
    return Metric(tensors, free, hourglass)


def _shares(weights: np.ndarray, gradients: np.ndarray, corner_mass: np.ndarray) -> np.ndarray:
    """Masses (m, q, a) [kg] that the points get of the corners: any are right, these make the points much alike."""
    share = weights[..., None] * np.linalg.norm(gradients, axis=3)
    share *= (corner_mass / share.sum(axis=1))[:, None]
    for _round in range(EVENING_ROUNDS):
        share *= np.sqrt(_largest(_symmetric(weights, gradients, share)))[..., None]
        share *= (corner_mass / share.sum(axis=1))[:, None]
    return share


def _symmetric(weights: np.ndarray, gradients: np.ndarray, share: np.ndarray) -> np.ndarray:
    """H (m, q, 6) [1/(kg m^-1)] for the shares of mass."""
    over_mass = np.divide(weights[..., None], share, out=np.zeros_like(share), where=share > 0.0)
    tensors = np.zeros((*weights.shape, 6))
    for k, (i, j) in enumerate(COMPONENTS):
        if j < gradients.shape[3] and i < gradients.shape[3]:
            tensors[..., k] = np.einsum("eqa,eqa,eqa->eq", over_mass, gradients[..., i], gradients[..., j])
    return tensors


def _largest(tensors: np.ndarray) -> np.ndarray:
    """A bound of the largest eigenvalue of symmetric tensors (..., 6), exact if two are equal."""
    third = tensors[..., :3].mean(axis=-1, keepdims=True)
    square = ((tensors[..., :3] - third) ** 2).sum(axis=-1) + 2.0 * (tensors[..., 3:] ** 2).sum(axis=-1)
    return third[..., 0] + np.sqrt(square * (2.0 / 3.0))

"""What the estimate of the stable step needs of the reference body: see `fem.stable_step`."""

from typing import NamedTuple

import numpy as np

from core_models.geometry import Axisymmetric, Geometry
from fem.tables import Tables


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
    gradients = tables.gradients
    free = np.ones(len(points))
    if isinstance(geometry, Axisymmetric):
        free = (points[:, 0] > 0.0).astype(np.float64)
        gradients = gradients.copy()
        gradients[..., 2] *= free[tables.nodes][:, None]
    length = np.sqrt((gradients**2).sum(axis=3))
    share = tables.weights[..., None] * length
    share *= (corner_mass / share.sum(axis=1))[:, None]
    over_mass = np.divide(tables.weights[..., None], share, out=np.zeros_like(share), where=share > 0.0)
    full = np.zeros((*tables.weights.shape, 3, 3))
    components = gradients.shape[3]
    full[..., :components, :components] = np.einsum("eqa,eqai,eqaj->eqij", over_mass, gradients, gradients)
    tensors = full[..., [0, 1, 2, 0, 1, 2], [0, 1, 2, 1, 2, 0]]
    return Metric(np.ascontiguousarray(tensors), free, hourglass)

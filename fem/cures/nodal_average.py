"""Nodal averages for one-point elements: the volume ratio is averaged over patches of elements.

    theta_n = sum_e V_e J_e / sum_e V_e over the elements round node n,   theta_e = mean of theta_n over its nodes

V_e are reference volumes. Symmetric with respect to them, so the forces still come from an energy; the mean stress
goes the same way. An element by itself has no freedom to keep its volume, a patch has.
Source: Bonet & Burton, Commun. Numer. Meth. Engng 14 (1998) 437, here in the form of a symmetric projection.
"""

from typing import NamedTuple

import numpy as np

from core_models.compilation import kernel
from core_models.state import read
from core_models.tensors import THIRD
from fem.cures.projection import PRESSURE, PROJECTED, RATIO, project
from fem.elements import nodes_of, points_of
from fem.geometries import point_gradient, ratios_of

NODE_CHUNK = 256


class NodalAverage(NamedTuple):
    """means : (n, 2) averages round each node: of the volume ratio [-] and of the mean stress [Pa]."""

    means: np.ndarray


@project.register(NodalAverage)
def _(cure, element, tables, e, scratch, column):
    total = 0.0
    for a in range(nodes_of(element)):
        total += cure.means[tables.nodes[e, a], column]
    mean = total / nodes_of(element)
    for q in range(points_of(element)):
        scratch[q, PROJECTED + column] = mean


@kernel
def average_ratios(first, last, geometry, element, tables, start, entries, x, means):
    """Fill the volume ratios of NodalAverage.means for nodes at x (n, d) [m], chunks of nodes first ... last-1."""
    for chunk in range(first, last):
        for node in range(chunk * NODE_CHUNK, min((chunk + 1) * NODE_CHUNK, means.shape[0])):
            total, reference = 0.0, 0.0
            for entry in range(start[node], start[node + 1]):
                e = entries[entry] // nodes_of(element)
                ratio, _area, _possible = ratios_of(
                    geometry, point_gradient(geometry, element, tables, x, e, 0)
                )
                total += tables.weights[e, 0] * ratio
                reference += tables.weights[e, 0]
            means[node, RATIO] = total / reference


@kernel
def average_pressures(first, last, element, tables, start, entries, stress, viscous, means):
    """Fill the mean stresses, net of viscosity, of NodalAverage.means: stress (m, 6), viscous (m,) or None [Pa]."""
    for chunk in range(first, last):
        for node in range(chunk * NODE_CHUNK, min((chunk + 1) * NODE_CHUNK, means.shape[0])):
            total, reference = 0.0, 0.0
            for entry in range(start[node], start[node + 1]):
                e = entries[entry] // nodes_of(element)
                pressure = (stress[e, 0] + stress[e, 1] + stress[e, 2]) * THIRD - read(viscous, e, 0.0)
                total += tables.weights[e, 0] * pressure
                reference += tables.weights[e, 0]
            means[node, PRESSURE] = total / reference

"""Hourglass control of one-point quads and hexahedra, from a potential.

    gamma_a = h_a - sum_b h_b X_b . G_a,   q = sum_a gamma_a x_a,   W = 1/2 k |q|^2,   f_a = - k q gamma_a

h are the patterns that the one point does not see, G_a the mean gradients. gamma is orthogonal to all linear fields,
so W leaves the patch test alone, and |q| does not change when the body turns. k is a part of the shear stiffness:

    k = coefficient G V sum_a |G_a|^2 / (n gamma . gamma)

Source: Flanagan & Belytschko, Int. J. Numer. Meth. Engng 17 (1981) 679, stiffness form, here in the reference body.
"""

from typing import NamedTuple

import numpy as np

from core_models.compilation import kernel
from fem.deformation import ELEMENT_CHUNK
from fem.elements import nodes_of
from fem.geometries import dimension_of
from fem.tables import Tables
from meshes.kinds import KINDS

DEFAULT = 0.02


class Hourglass(NamedTuple):
    """patterns : (m, h, a) gamma [-]. stiffness : (m, h) k [N/m]."""

    patterns: np.ndarray
    stiffness: np.ndarray


def make_hourglass(
    kind: str, points: np.ndarray, tables: Tables, shear: float, coefficient: float
) -> Hourglass:
    """Hourglass control of the elements of a mesh with nodes at points (n, d) [m]; shear modulus [Pa]."""
    signs = 2.0 * KINDS[kind].reference_nodes - 1.0
    products = [(0, 1)] if signs.shape[1] == 2 else [(1, 2), (0, 2), (0, 1), (0, 1, 2)]
    bases = np.array([signs[:, list(which)].prod(axis=1) for which in products])
    gradients = tables.gradients[:, 0, :, : signs.shape[1]]
    fitted = np.einsum("hb,ebi,eai->eha", bases, points[tables.nodes], gradients)
    patterns = np.ascontiguousarray(bases[None] - fitted)
    size = tables.weights[:, 0] * (gradients**2).sum(axis=(1, 2)) / len(signs)
    stiffness = coefficient * shear * size[:, None] / (patterns**2).sum(axis=2)
    return Hourglass(patterns, np.ascontiguousarray(stiffness))


def square_frequencies(hourglass: Hourglass, corner_mass: np.ndarray) -> np.ndarray:
    """Square of the largest frequency of the control in each element (m,) [1/s^2]."""
    scaled = hourglass.patterns * np.sqrt(hourglass.stiffness[..., None] / corner_mass[:, None])
    return np.linalg.norm(scaled, ord=2, axis=(1, 2)) ** 2


@kernel
def resist_hourglass(first, last, geometry, element, nodes, hourglass, x, corner_forces, energies):
    """Add the forces of the control to corner_forces (m, a, d) [N]; its energy to energies (chunks,) [J].

    first, last : chunks of ELEMENT_CHUNK elements. x : (n, d) positions of the nodes [m].
    """
    for chunk in range(first, last):
        energies[chunk] = 0.0
        for e in range(chunk * ELEMENT_CHUNK, min((chunk + 1) * ELEMENT_CHUNK, nodes.shape[0])):
            for h in range(hourglass.patterns.shape[1]):
                stiffness = hourglass.stiffness[e, h]
                for i in range(dimension_of(geometry)):
                    strain = 0.0
                    for a in range(nodes_of(element)):
                        strain += hourglass.patterns[e, h, a] * x[nodes[e, a], i]
                    energies[chunk] += 0.5 * stiffness * strain * strain
                    for a in range(nodes_of(element)):
                        corner_forces[e, a, i] -= stiffness * strain * hourglass.patterns[e, h, a]

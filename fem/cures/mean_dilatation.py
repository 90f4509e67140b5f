"""Mean dilatation: the volume ratio is that of the whole element (Q1/P0 for linear quads and hexahedra).

In six-node triangles and ten-node tetrahedra (P2/P0) it is stable, but constrains little: per element there are four
displacements to one volume ratio, against two (Q1/P0 in the plane) or three that the continuum has. They answer too
softly, by 0.5 % of the length of the classic Taylor bar; a linear volume ratio in each of them would not be stable.

Its part of the stiffness is of rank one, so its part of the stable step is known exactly (`fem.stable_step`):

    omega^2 <= (1 - share^2) K / V sum_a |b_a|^2 / m_a + max_q [share^2 K tr h + 2 G min(lambda, 2/3 tr h)],

    b_a = sum_q w J g_a

with g_a the current gradients of the shape functions; in the axisymmetric body the hoop's share is in b_r.
"""

from typing import NamedTuple

from core_models.dispatch import generic
from core_models.geometry import Axisymmetric, PlaneStrain, Spatial
from fem.cures.projection import PROJECTED, project
from fem.elements import nodes_of, points_of
from fem.stable_step import SPREAD, TRACE, VOLUME, bulk_part, shear_part, square_frequency


class MeanDilatation(NamedTuple):
    """theta_q = (1 - share) sum_k w_k J_k / sum_k w_k + share J_q in each element; the mean stress likewise."""

    share: float


@project.register(MeanDilatation)
def _(cure, element, tables, e, scratch, column):
    total, reference = 0.0, 0.0
    for q in range(points_of(element)):
        total += tables.weights[e, q] * scratch[q, column]
        reference += tables.weights[e, q]
    mean = (1.0 - cure.share) * total / reference
    for q in range(points_of(element)):
        scratch[q, PROJECTED + column] = mean + cure.share * scratch[q, column]


@square_frequency.register(MeanDilatation)
def _(cure, geometry, element, tables, metric, scratch, e, corner_mass, shear):
    bulk, apart, volume, mode, kept = 0.0, 0.0, 0.0, 0.0, cure.share * cure.share
    for q in range(points_of(element)):
        own = bulk_part(scratch, q, shear)
        bulk = max(bulk, own)
        apart = max(apart, kept * own * scratch[q, TRACE] + shear_part(scratch, q, shear))
        volume += scratch[q, VOLUME]
    for a in range(nodes_of(element)):
        free = metric.free[tables.nodes[e, a]]
        mode += square_divergence(geometry, element, tables, scratch, e, a, free) / corner_mass[e, a]
    return (1.0 - kept) * bulk * mode / volume + apart


@generic
def square_divergence(geometry, element, tables, scratch, e, a, free):
    """|b_a|^2 of corner a [m^4]; free : 0 for a node whose radius is fixed, else 1."""


@square_divergence.register(Axisymmetric)
def _(geometry, element, tables, scratch, e, a, free):
    r, z = 0.0, 0.0
    for q in range(points_of(element)):
        gr, gz, gh = tables.gradients[e, q, a, 0], tables.gradients[e, q, a, 1], tables.gradients[e, q, a, 2]
        r += scratch[q, SPREAD] * gr + scratch[q, SPREAD + 1] * gz + scratch[q, SPREAD + 4] * gh
        z += scratch[q, SPREAD + 2] * gr + scratch[q, SPREAD + 3] * gz
    return free * r * r + z * z


@square_divergence.register(PlaneStrain)
def _(geometry, element, tables, scratch, e, a, free):
    x, y = 0.0, 0.0
    for q in range(points_of(element)):
        gx, gy = tables.gradients[e, q, a, 0], tables.gradients[e, q, a, 1]
        x += scratch[q, SPREAD] * gx + scratch[q, SPREAD + 1] * gy
        y += scratch[q, SPREAD + 2] * gx + scratch[q, SPREAD + 3] * gy
    return x * x + y * y


@square_divergence.register(Spatial)
def _(geometry, element, tables, scratch, e, a, free):
    x, y, z = 0.0, 0.0, 0.0
    for q in range(points_of(element)):
        g0, g1, g2 = tables.gradients[e, q, a, 0], tables.gradients[e, q, a, 1], tables.gradients[e, q, a, 2]
        x += scratch[q, SPREAD] * g0 + scratch[q, SPREAD + 1] * g1 + scratch[q, SPREAD + 2] * g2
        y += scratch[q, SPREAD + 3] * g0 + scratch[q, SPREAD + 4] * g1 + scratch[q, SPREAD + 5] * g2
        z += scratch[q, SPREAD + 6] * g0 + scratch[q, SPREAD + 7] * g1 + scratch[q, SPREAD + 8] * g2
    return x * x + y * y + z * z

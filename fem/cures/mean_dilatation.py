"""Mean dilatation: the volume ratio is that of the whole element (Q1/P0 for linear quads and hexahedra)."""

from typing import NamedTuple

from fem.cures.projection import PROJECTED, project
from fem.elements import points_of


class MeanDilatation(NamedTuple):
    """theta = sum_q w_q J_q / sum_q w_q in each element; the mean stress likewise."""


@project.register(MeanDilatation)
def _(cure, element, tables, e, scratch, column):
    total, reference = 0.0, 0.0
    for q in range(points_of(element)):
        total += tables.weights[e, q] * scratch[q, column]
        reference += tables.weights[e, q]
    mean = total / reference
    for q in range(points_of(element)):
        scratch[q, PROJECTED + column] = mean

"""Consistent tangent of a step: what the first Piola stress does when the deformation gradient after it changes.

    P = tau F^-T,   dP = (dtau - tau l^T) F^-T,   l = dF F^-1,   tau = J sigma

The tangent is assembled from the exact derivatives of the stress update in the nine directions of F; each update
says what its Kirchhoff stress tau does in one of them.
"""

from typing import NamedTuple

from core_models.compilation import inside_kernel
from core_models.dispatch import generic
from core_models.tensors import full, product, product_transposed, scaled, symmetric_part


class Direction(NamedTuple):
    """A change of the deformation gradient after the step: dF, l = dF F^-1 (nine components) and dJ."""

    gradient: tuple
    relative: tuple
    volume_ratio: float


@generic
def linearise_rows(update, rows, statuses, count, model, dt, start, stresses, tangents):
    """A step of the points in the rows as `advance_rows` makes it, without viscosity, and its linearisation.

    Parameters
    ----------
    update, rows, statuses, count, model, dt : see `advance_rows` (core_models.updates.interface).
    start : the first point.
    stresses, tangents : (n, 9) first Piola stress P [Pa] and (n, 9, 9) dP/dF [Pa], written from `start` on.
    """


@inside_kernel
def direction(number, inverse_gradient, volume_ratio):
    """Change of one component of F, from F^-1 and J."""
    gradient = (
        unit(number, 0), unit(number, 1), unit(number, 2), unit(number, 3), unit(number, 4), unit(number, 5),
        unit(number, 6), unit(number, 7), unit(number, 8),
    )  # fmt: skip
    relative = product(gradient, inverse_gradient)
    return Direction(gradient, relative, volume_ratio * (relative[0] + relative[4] + relative[8]))


@inside_kernel
def unit(number, component):
    """1 for equal numbers, else 0."""
    return 1.0 if number == component else 0.0


@inside_kernel
def transported(relative, s):
    """Symmetric tensor l s + s l^T."""
    return scaled(symmetric_part(product(relative, full(s))), 2.0)


@inside_kernel
def put_stress(stresses, point, kirchhoff, inverse_gradient):
    """Write the first Piola stress of a point."""
    p = product_transposed(full(kirchhoff), inverse_gradient)
    for row in range(9):
        stresses[point, row] = p[row]


@inside_kernel
def put_nothing(stresses, tangents, point):
    """Write stress and tangent of a point that is out of the simulation."""
    for row in range(9):
        stresses[point, row] = 0.0
        for column in range(9):
            tangents[point, row, column] = 0.0


@inside_kernel
def put_change(tangents, point, number, change, kirchhoff, towards, inverse_gradient):
    """Write a column of the tangent of a point: dtau and tau in the direction of a component of F."""
    pulled = product_transposed(full(kirchhoff), towards.relative)
    c = full(change)
    difference = (
        c[0] - pulled[0], c[1] - pulled[1], c[2] - pulled[2], c[3] - pulled[3], c[4] - pulled[4],
        c[5] - pulled[5], c[6] - pulled[6], c[7] - pulled[7], c[8] - pulled[8],
    )  # fmt: skip
    column = product_transposed(difference, inverse_gradient)
    for row in range(9):
        tangents[point, row, number] = column[row]

"""Linearisation of orthotropic elasticity."""

from core_models.compilation import inside_kernel
from core_models.laws import advance_rows
from core_models.rows import F1, STRESS, get_symmetric, get_tensor
from core_models.status import OK
from core_models.tensors import (
    congruence,
    determinant,
    inverse,
    plus,
    product,
    scaled,
    symmetric_part,
    transposed_product,
)
from core_models.updates.orthotropic import Orthotropic, stiffened, towards_axes
from core_models.updates.tangent import direction, linearise_rows, put_change, put_stress, transported


@linearise_rows.register(Orthotropic)
def _(update, rows, statuses, count, model, dt, start, stresses, tangents):
    advance_rows(update, rows, statuses, count, model, None, dt)
    for k in range(count):
        if statuses[k] == OK:
            linearise_axes(
                update, get_tensor(rows, F1, k), get_symmetric(rows, STRESS, k), start + k, stresses, tangents
            )


@inside_kernel
def linearise_axes(update, f, stress, place, stresses, tangents):
    """Write first Piola stress and tangent of a point: dtau = l tau + tau l^T + F (C : F^T sym(l) F) F^T."""
    j = determinant(f)
    inverse_f = inverse(f, j)
    tau = scaled(stress, j)
    put_stress(stresses, place, tau, inverse_f)
    axes = towards_axes(update, f)
    for number in range(9):
        towards = direction(number, inverse_f, j)
        straining = symmetric_part(transposed_product(axes, product(towards.relative, axes)))
        change = plus(transported(towards.relative, tau), congruence(axes, stiffened(update, straining)))
        put_change(tangents, place, number, change, tau, towards, inverse_f)

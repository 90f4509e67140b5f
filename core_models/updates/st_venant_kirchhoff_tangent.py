"""Linearisation of St. Venant-Kirchhoff elasticity."""

from core_models.compilation import inside_kernel
from core_models.elasticity.stiffness import stressed
from core_models.laws import stiffness
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
from core_models.updates.interface import advance_rows
from core_models.updates.st_venant_kirchhoff import StVenantKirchhoff
from core_models.updates.tangent import direction, linearise_rows, put_change, put_stress, transported


@linearise_rows.register(StVenantKirchhoff)
def _(update, rows, statuses, count, model, dt, start, stresses, tangents):
    advance_rows(update, rows, statuses, count, model, None, dt)
    elastic = stiffness(model.elasticity)
    for k in range(count):
        if statuses[k] == OK:
            linearise_strained(
                elastic,
                get_tensor(rows, F1, k),
                get_symmetric(rows, STRESS, k),
                start + k,
                stresses,
                tangents,
            )


@inside_kernel
def linearise_strained(elastic, f, stress, place, stresses, tangents):
    """Write first Piola stress and tangent of a point: dtau = l tau + tau l^T + F dS F^T, dS = C : sym(F^T dF)."""
    j = determinant(f)
    inverse_f = inverse(f, j)
    tau = scaled(stress, j)
    g = product(f, elastic.axes)
    put_stress(stresses, place, tau, inverse_f)
    for number in range(9):
        towards = direction(number, inverse_f, j)
        strain = symmetric_part(transposed_product(g, product(towards.gradient, elastic.axes)))
        change = plus(transported(towards.relative, tau), congruence(g, stressed(elastic, strain)))
        put_change(tangents, place, number, change, tau, towards, inverse_f)

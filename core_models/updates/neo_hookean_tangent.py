"""Linearisation of compressible neo-Hookean elasticity."""

from core_models.compilation import inside_kernel
from core_models.laws import elastic_moduli
from core_models.rows import F1, STRESS, get_symmetric, get_tensor
from core_models.status import OK
from core_models.tensors import (
    determinant,
    inverse,
    plus_isotropic,
    product_transposed,
    scaled,
    symmetric_part,
)
from core_models.updates.compressible_neo_hookean import TWO_THIRDS, CompressibleNeoHookean
from core_models.updates.interface import advance_rows
from core_models.updates.tangent import direction, linearise_rows, put_change, put_stress, transported


@linearise_rows.register(CompressibleNeoHookean)
def _(update, rows, statuses, count, model, dt, start, stresses, tangents):
    advance_rows(update, rows, statuses, count, model, None, dt)
    for k in range(count):
        if statuses[k] == OK:
            linearise_point(
                model, get_tensor(rows, F1, k), get_symmetric(rows, STRESS, k), start + k, stresses, tangents
            )


@inside_kernel
def linearise_point(model, f, stress, place, stresses, tangents):
    """Write first Piola stress and tangent of a point: dtau = mu (l b + b l^T) + lambda tr(l) 1."""
    bulk, shear = elastic_moduli(model.elasticity)
    lame = bulk - TWO_THIRDS * shear
    j = determinant(f)
    inverse_f = inverse(f, j)
    tau = scaled(stress, j)
    b = symmetric_part(product_transposed(f, f))
    put_stress(stresses, place, tau, inverse_f)
    for number in range(9):
        towards = direction(number, inverse_f, j)
        change = plus_isotropic(
            scaled(transported(towards.relative, b), shear), lame * towards.volume_ratio / j
        )
        put_change(tangents, place, number, change, tau, towards, inverse_f)

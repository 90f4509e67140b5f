"""Linearisation of fibre-reinforced neo-Hookean elasticity."""

from core_models.compilation import inside_kernel
from core_models.laws import elastic_moduli
from core_models.rows import F1, STRESS, get_symmetric, get_tensor
from core_models.status import OK
from core_models.tensors import (
    determinant,
    inverse,
    plus,
    plus_isotropic,
    product_transposed,
    scaled,
    symmetric_part,
)
from core_models.updates.compressible_neo_hookean import TWO_THIRDS
from core_models.updates.fibre_reinforced import FibreReinforced, dyad, stretched
from core_models.updates.interface import advance_rows
from core_models.updates.tangent import direction, linearise_rows, put_change, put_stress, transported


@linearise_rows.register(FibreReinforced)
def _(update, rows, statuses, count, model, dt, start, stresses, tangents):
    advance_rows(update, rows, statuses, count, model, None, dt)
    for k in range(count):
        if statuses[k] == OK:
            linearise_fibres(
                update,
                model,
                get_tensor(rows, F1, k),
                get_symmetric(rows, STRESS, k),
                start + k,
                stresses,
                tangents,
            )


@inside_kernel
def linearise_fibres(update, model, f, stress, place, stresses, tangents):
    """Write first Piola stress and tangent of a point: dtau = 2 W' (l A + A l^T) + 4 W'' (a.l a) A, A = a (x) a, and
    that of the matrix.
    """
    bulk, shear = elastic_moduli(model.elasticity)
    lame = bulk - TWO_THIRDS * shear
    j = determinant(f)
    inverse_f = inverse(f, j)
    tau = scaled(stress, j)
    fibres = stretched(update, f)
    along = dyad(fibres.vector)
    carried = plus(scaled(symmetric_part(product_transposed(f, f)), shear), scaled(along, 2.0 * fibres.slope))
    put_stress(stresses, place, tau, inverse_f)
    for number in range(9):
        towards = direction(number, inverse_f, j)
        moved = transported(towards.relative, along)
        stretching = moved[0] + moved[1] + moved[2]  # dI_4
        change = plus(
            transported(towards.relative, carried), scaled(along, 2.0 * fibres.curvature * stretching)
        )
        put_change(
            tangents,
            place,
            number,
            plus_isotropic(change, lame * towards.volume_ratio / j),
            tau,
            towards,
            inverse_f,
        )

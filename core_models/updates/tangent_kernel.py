"""The kernel that advances points by a step and linearises it; compiled for a material when it is first called."""

from core_models.columns import gather, get_point, scatter
from core_models.compilation import CHUNK, material_kernel
from core_models.kernels import add_balance, is_finite
from core_models.rows import BLOCK
from core_models.status import NOT_FINITE, OK
from core_models.updates import (  # noqa: F401
    anisotropic_tangent,
    fibre_reinforced_tangent,
    general_tangent,
    hyperelastic_tangent,
    hypoelastic_tangent,
    neo_hookean_tangent,
    st_venant_kirchhoff_tangent,
)
from core_models.updates.balance import get_balance
from core_models.updates.tangent import linearise_rows


@material_kernel
def linearise_points(
    first,
    last,
    workspace,
    model,
    f0,
    f1,
    dt,
    volumes,
    old,
    new,
    wave_speed,
    sums,
    failures,
    stresses,
    tangents,
):
    """Advance and linearise the points of chunks first ... last-1.

    Parameters
    ----------
    See `advance_points` (core_models.kernels). stresses, tangents : (n, 9) first Piola stress [Pa] and (n, 9, 9)
    dP/dF [Pa], written.
    """
    n = f1.shape[0]
    rows, statuses = workspace
    for chunk in range(first, last):
        for column in range(sums.shape[1]):
            sums[chunk, column] = 0.0
        failures[chunk, 0] = OK
        end = min((chunk + 1) * CHUNK, n)
        for start in range(chunk * CHUNK, end, BLOCK):
            count = min(BLOCK, end - start)
            gather(rows, start, count, f0, f1, None, old)
            linearise_rows(model.update, rows, statuses, count, model, dt, start, stresses, tangents)
            scatter(rows, start, count, new, wave_speed, None)
            for k in range(count):
                balance = get_balance(rows, k)
                add_balance(sums, chunk, volumes[start + k], balance)
                if statuses[k] == OK and not is_finite(balance, get_point(rows, k)):
                    statuses[k] = NOT_FINITE
                if statuses[k] != OK and failures[chunk, 0] == OK:
                    failures[chunk, 0] = statuses[k]
                    failures[chunk, 1] = start + k

"""The tangent of continued flow: that of the next, infinitely small step from where points are, at constant rate.

Other than the tangent of a step it leaves the change of the rate out, which would hide every instability behind the
smallest rate dependence, and takes the heat of the plastic work in.
"""

from core_models.columns import gather
from core_models.compilation import CHUNK, material_kernel
from core_models.rows import BLOCK
from core_models.updates import general_continuing  # noqa: F401
from core_models.updates.continued_flow import continue_point


@material_kernel
def continuing_tangents(first, last, workspace, model, f, state, stresses, tangents):
    """Tangents of continued flow of the points of chunks first ... last-1.

    Parameters
    ----------
    workspace, model : see `advance_points` (core_models.kernels). f, state : (n, 9) deformation gradient, `State`.
    stresses, tangents : (n, 9) first Piola stress [Pa] and (n, 9, 9) dP/dF [Pa], written.
    """
    n = f.shape[0]
    rows, _statuses = workspace
    for chunk in range(first, last):
        end = min((chunk + 1) * CHUNK, n)
        for start in range(chunk * CHUNK, end, BLOCK):
            count = min(BLOCK, end - start)
            gather(rows, start, count, f, f, None, state)
            for k in range(count):
                continue_point(model.update, model, rows, k, start + k, stresses, tangents)

"""From the coefficients of the grid to the deformation gradients that the particles see.

With x_a the coefficients of the functions, F_q = sum_a x_a grad N_a(X_q) and the hoop stretch of a body of revolution
sum_a r_a N_a(X_q) / R_q. The cure lets the particles of a cell, q, see the mean of their changes of volume but for a
share alpha:

    Fbar_q = s_q F_q,   s_q = (theta_q / J_q)^(1/3),   theta_q = (1 - alpha) sum_q V_q J_q / sum_q V_q + alpha J_q
"""

from core_models.compilation import beside_kernel, kernel
from core_models.status import INVERTED, OK
from core_models.tensors import cube_root, determinant, load_tensor

CELL_CHUNK = 32  # cells; fixed, so that results do not depend on the number of threads


@beside_kernel
def put_gradient(gradients, p, nodes, e, slopes, operator, x):
    """Write F of particle p of cell e; a component that no coefficient changes is that of the unit tensor."""
    for i in range(3):
        for j in range(3):
            gradients[p, i, j] = 0.0
    if slopes.shape[2] == 2:
        gradients[p, 2, 2] = 1.0
    for a in range(nodes.shape[1]):
        for i in range(x.shape[1]):
            for j in range(operator.counts[i]):
                row = operator.rows[i, j]
                gradients[p, row // 3, row % 3] += x[nodes[e, a], i] * slopes[p, a, j]


@kernel
def deform_cells(
    first, last, share, starts, order, nodes, slopes, operator, volumes, x, gradients, scales, failures
):
    """Deformation gradients of the particles of chunks first ... last-1 of CELL_CHUNK cells.

    Parameters
    ----------
    share : alpha, 1 without the cure. starts, order, nodes : of `SplineGrid`. slopes (n, a, D) : of the functions at
    the particles, operator : `GradientOperator`, what D means. volumes (n,) : reference [m^3]. x (k, d) : coefficients
    [m]. gradients (n, 3, 3) : Fbar, written. scales (n,) : s, written. failures (chunks, 2) : status and particle.
    """
    for chunk in range(first, last):
        failures[chunk, 0] = OK
        for e in range(chunk * CELL_CHUNK, min((chunk + 1) * CELL_CHUNK, nodes.shape[0])):
            volume, current = 0.0, 0.0
            for q in range(starts[e], starts[e + 1]):
                p = order[q]
                put_gradient(gradients, p, nodes, e, slopes, operator, x)
                ratio = determinant(load_tensor(gradients, p))
                if not ratio > 0.0:
                    failures[chunk, 0], failures[chunk, 1] = INVERTED, p
                scales[p] = ratio
                volume, current = volume + volumes[p], current + volumes[p] * ratio
            for q in range(starts[e], starts[e + 1]):
                p = order[q]
                mean = (1.0 - share) * current / volume
                s = cube_root(mean / scales[p] + share) if share < 1.0 and scales[p] > 0.0 else 1.0
                scales[p] = s
                for i in range(3):
                    for j in range(3):
                        gradients[p, i, j] *= s

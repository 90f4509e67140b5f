"""Forces and stiffness of the cells of the grid, the terms of the cure included.

In the terms of `core_models.equilibrium.mean_dilatation`, with V_q the reference volumes of the particles of a cell, W
their sum, G_q = dF_q / dx, alpha the share of its own change of volume that a particle sees, beta = 1 - alpha, and
P p = beta sum_q V_q p_q / W + alpha p_q,

    f = sum_q V_q G_q^T [A_q + (P p)_q C_q]
    df/dx = sum_q V_q G_q^T B_q G_q + a (x) g + g (x) b + n g (x) g,     g = sum_q V_q G_q^T C_q / W
    B = A_F + (P p) dC/dF + alpha (A_theta (x) C + C (x) m) + alpha^2 n_q C (x) C
    a = beta sum_q V_q G_q^T (A_theta + alpha n_q C)_q,  b likewise with m,  n = beta^2 sum_q V_q n_q

exactly. Without the cure, alpha = 1, f = sum_q V_q G_q^T P_q, and the stiffness is that of dP/dF.
"""

from typing import NamedTuple

import numpy as np

from core_models.compilation import beside_kernel, kernel
from core_models.equilibrium.mean_dilatation import (
    COFACTOR,
    FORCE,
    MEAN,
    OWN,
    VECTORS,
    linearise_point,
    put_cofactor,
)
from core_models.tensors import THIRD
from mpm.implicit.deformation import CELL_CHUNK


class CellScratch(NamedTuple):
    """What a thread needs for one cell: vectors (VECTORS, 9), matrix (9, 9) and half (dofs, 9) of one
    particle, g, a and b (dofs,) of the cell.
    """

    vectors: np.ndarray
    matrix: np.ndarray
    half: np.ndarray
    g: np.ndarray
    a: np.ndarray
    b: np.ndarray


def make_scratch(dofs: int) -> CellScratch:
    """Scratch for cells of so many degrees of freedom."""
    return CellScratch(
        np.zeros((VECTORS, 9)), np.zeros((9, 9)), np.zeros((dofs, 9)), np.zeros(dofs), np.zeros(dofs), np.zeros(dofs)
    )  # fmt: skip


@kernel
def stiffen_cells(
    first, last, scratch, share, starts, order, slopes, operator, volumes, gradients, scales, stresses, tangents,
    pressures, forces, matrices,
):  # fmt: skip
    """Forces of the cells on their functions, and their derivatives, for chunks of CELL_CHUNK cells.

    Parameters
    ----------
    first, last : chunks. scratch : `CellScratch`, the thread's own. share ... scales : as `deform_cells` takes and
    leaves them. stresses (n, 3, 3) : Pbar, tangents (n, 9, 9) : dPbar / dFbar [Pa]. pressures (n,) : p, written.
    forces (m, a d) : -f [N], written. matrices (m, a d, a d) : df/dx [N/m], written.
    """
    for chunk in range(first, last):
        for e in range(chunk * CELL_CHUNK, min((chunk + 1) * CELL_CHUNK, forces.shape[0])):
            clear(scratch, forces, matrices, e)
            pressure, total = 0.0, 0.0
            if share < 1.0:
                pressure = (1.0 - share) * put_mean(
                    scratch,
                    starts,
                    order,
                    slopes,
                    operator,
                    volumes,
                    gradients,
                    scales,
                    stresses,
                    pressures,
                    e,
                )
            for q in range(starts[e], starts[e + 1]):
                p = order[q]
                if share < 1.0:
                    n = linearise_point(
                        scratch.vectors, scratch.matrix, gradients, scales[p], stresses, tangents, p,
                        pressure + share * pressures[p],
                    )  # fmt: skip
                    put_share(scratch, share, n)
                    total += volumes[p] * (1.0 - share) * (1.0 - share) * n
                else:
                    put_point(scratch, stresses, tangents, p)
                add_point(scratch, slopes, operator, volumes[p], p, e, share < 1.0, forces, matrices)
            if share < 1.0:
                add_mean(scratch, total, e, matrices)


@beside_kernel
def clear(scratch, forces, matrices, e):
    """Set to 0 what particles add to."""
    for i in range(forces.shape[1]):
        forces[e, i] = 0.0
        scratch.g[i], scratch.a[i], scratch.b[i] = 0.0, 0.0, 0.0
        for j in range(forces.shape[1]):
            matrices[e, i, j] = 0.0


@beside_kernel
def put_mean(scratch, starts, order, slopes, operator, volumes, gradients, scales, stresses, pressures, e):
    """Fill g and the pressures of cell e; returns the mean of these."""
    volume, pressure, d = 0.0, 0.0, operator.rows.shape[0]
    for q in range(starts[e], starts[e + 1]):
        p = order[q]
        theta, work = put_cofactor(gradients, p, 1.0 / scales[p], scratch.vectors), 0.0
        for row in range(9):
            work += stresses[p, row // 3, row % 3] * gradients[p, row // 3, row % 3]
        pressures[p] = work * THIRD / theta
        pressure += volumes[p] * pressures[p]
        volume += volumes[p]
        for a in range(slopes.shape[1]):
            for i in range(d):
                for j in range(operator.counts[i]):
                    scratch.g[d * a + i] += (
                        volumes[p] * scratch.vectors[COFACTOR, operator.rows[i, j]] * slopes[p, a, j]
                    )
    for dof in range(scratch.g.shape[0]):
        scratch.g[dof] /= volume
    return pressure / volume


@beside_kernel
def put_share(scratch, share, n):
    """Turn A_F + (P p) dC/dF, A_theta and m of a particle into B and what a and b are sums of."""
    v, b = scratch.vectors, scratch.matrix
    for i in range(9):
        for j in range(9):
            own = v[OWN, i] * v[COFACTOR, j] + v[COFACTOR, i] * v[MEAN, j]
            b[i, j] += share * (own + share * n * v[COFACTOR, i] * v[COFACTOR, j])
    for i in range(9):
        v[OWN, i] = (1.0 - share) * (v[OWN, i] + share * n * v[COFACTOR, i])
        v[MEAN, i] = (1.0 - share) * (v[MEAN, i] + share * n * v[COFACTOR, i])


@beside_kernel
def put_point(scratch, stresses, tangents, p):
    """Let the particle's own stress and tangent stand for A + (P p) C and A_F + (P p) dC/dF."""
    for i in range(9):
        scratch.vectors[FORCE, i] = stresses[p, i // 3, i % 3]
        for j in range(9):
            scratch.matrix[i, j] = tangents[p, i, j]


@beside_kernel
def add_point(scratch, slopes, operator, volume, p, e, cured, forces, matrices):
    """Add what particle p of cell e gives to forces, matrix, a and b."""
    v, b, half, d = scratch.vectors, scratch.matrix, scratch.half, operator.rows.shape[0]
    for a in range(slopes.shape[1]):
        for i in range(d):
            dof = d * a + i
            for column in range(9):
                half[dof, column] = 0.0
            for j in range(operator.counts[i]):
                g, row = volume * slopes[p, a, j], operator.rows[i, j]
                forces[e, dof] -= g * v[FORCE, row]
                if cured:
                    scratch.a[dof] += g * v[OWN, row]
                    scratch.b[dof] += g * v[MEAN, row]
                for column in range(9):
                    half[dof, column] += g * b[row, column]
    for i in range(d):
        for j in range(operator.counts[i]):
            row = operator.rows[i, j]
            for dof in range(half.shape[0]):
                part = half[dof, row]
                for a in range(slopes.shape[1]):
                    matrices[e, dof, d * a + i] += part * slopes[p, a, j]


@beside_kernel
def add_mean(scratch, n, e, matrices):
    """Add a (x) g + g (x) b + n g (x) g to the matrix of cell e."""
    a, b, g = scratch.a, scratch.b, scratch.g
    for i in range(g.shape[0]):
        for j in range(g.shape[0]):
            matrices[e, i, j] += a[i] * g[j] + g[i] * b[j] + n * g[i] * g[j]

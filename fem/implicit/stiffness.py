"""Forces and stiffness of the elements, the terms of a locking cure included.

With u the displacements of an element, F_q its gradient at point q, C = cof F, J = det F, theta = P J as the cure
projects it, s = (theta / J)^(1/3), Fbar = s F, Pbar the first Piola stress there, pi = Pbar : Fbar / 3, p = pi / theta:

    f = sum_q w_q G_q^T [A_q + (P p)_q C_q],     A = s Pbar - pi F^-T,     G_q = dF_q / du

A and p of a point depend on its own F and theta only. With dA = A_F dF + A_theta dtheta and dp = m dF + n dtheta, and
because w_q P_qk = w_k P_kq,

    df/du = sum_q w_q [G^T (A_F + (P p) dC/dF) G + a (x) g + g (x) b + n g (x) g]_q,
    a = G^T A_theta,  b = G^T m,  c = G^T C,  g_q = sum_k P_qk c_k

exactly, whatever the projection; it is not symmetric unless the tangent of the points comes from an energy. Without a
cure P = 1 and all of it is G^T (dP/dF) G.
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
from core_models.state import read
from core_models.tensors import THIRD
from fem.cures.projection import PRESSURE, PROJECTED, RATIO, project
from fem.deformation import ELEMENT_CHUNK
from fem.elements import MOST_POINTS, nodes_of, points_of


class ElementScratch(NamedTuple):
    """What a thread needs for one element.

    columns (points, 4) : for `project`. vectors (7, 9), matrix (9, 9), half (dofs, 9) : of one point. cofactors, means
    (points, dofs) : c and g. a, b (dofs,).
    """

    columns: np.ndarray
    vectors: np.ndarray
    matrix: np.ndarray
    half: np.ndarray
    cofactors: np.ndarray
    means: np.ndarray
    a: np.ndarray
    b: np.ndarray


def make_scratch(dofs: int) -> ElementScratch:
    """Scratch for elements of so many degrees of freedom."""
    return ElementScratch(
        np.zeros((MOST_POINTS, 4)), np.zeros((VECTORS, 9)), np.zeros((9, 9)), np.zeros((dofs, 9)),
        np.zeros((MOST_POINTS, dofs)), np.zeros((MOST_POINTS, dofs)), np.zeros(dofs), np.zeros(dofs),
    )  # fmt: skip


@kernel
def stiffen(
    first,
    last,
    scratch,
    element,
    cure,
    tables,
    operator,
    gradients,
    scales,
    stresses,
    tangents,
    forces,
    matrices,
):
    """Forces of the elements on their nodes, and their derivatives.

    Parameters
    ----------
    first, last : chunks of ELEMENT_CHUNK elements. scratch : `ElementScratch`, the thread's own.
    element, cure : what the kernel is compiled for. operator : `GradientOperator`.
    gradients (n, 3, 3) : Fbar, scales (n,) : s, or None, of the points, as `fem.deformation.deform` left them.
    stresses (n, 3, 3) : Pbar [Pa]. tangents (n, 9, 9) : dPbar / dFbar [Pa].
    forces (m, a d) : -f [N], written. matrices (m, a d, a d) : df/du [N/m], written.
    """
    points = points_of(element)
    elements = tables.nodes.shape[0]
    for chunk in range(first, last):
        for e in range(chunk * ELEMENT_CHUNK, min((chunk + 1) * ELEMENT_CHUNK, elements)):
            put_means(element, cure, tables, operator, gradients, scales, stresses, e, scratch)
            dofs = forces.shape[1]
            for i in range(dofs):
                forces[e, i] = 0.0
                for j in range(dofs):
                    matrices[e, i, j] = 0.0
            for q in range(points):
                k = points * e + q
                n = linearise_point(
                    scratch.vectors, scratch.matrix, gradients, read(scales, k, 1.0), stresses, tangents, k,
                    scratch.columns[q, PROJECTED + PRESSURE],
                )  # fmt: skip
                add_point(element, tables, operator, scratch, e, q, n, forces, matrices)


@beside_kernel
def put_means(element, cure, tables, operator, gradients, scales, stresses, e, scratch):
    """Fill c, g and the projected mean stress of the points of element e."""
    points, nodes = points_of(element), nodes_of(element)
    dimension = operator.rows.shape[0]
    for q in range(points):
        k = points * e + q
        s = read(scales, k, 1.0)
        theta, work = put_cofactor(gradients, k, 1.0 / s, scratch.vectors), 0.0
        for row in range(9):
            work += stresses[k, row // 3, row % 3] * gradients[k, row // 3, row % 3]
        scratch.columns[q, PRESSURE] = work * THIRD / theta
        for a in range(nodes):
            for i in range(dimension):
                total = 0.0
                for j in range(operator.counts[i]):
                    total += scratch.vectors[COFACTOR, operator.rows[i, j]] * tables.gradients[e, q, a, j]
                scratch.cofactors[q, dimension * a + i] = total
    project(cure, element, tables, e, scratch.columns, PRESSURE)
    for dof in range(dimension * nodes):
        for q in range(points):
            scratch.columns[q, RATIO] = scratch.cofactors[q, dof]
        project(cure, element, tables, e, scratch.columns, RATIO)
        for q in range(points):
            scratch.means[q, dof] = scratch.columns[q, PROJECTED + RATIO]


@beside_kernel
def add_point(element, tables, operator, scratch, e, q, n, forces, matrices):
    """Add what point q gives to forces and matrix of element e."""
    v, b, half = scratch.vectors, scratch.matrix, scratch.half
    nodes, dimension = nodes_of(element), operator.rows.shape[0]
    weight = tables.weights[e, q]
    for a in range(nodes):
        for i in range(dimension):
            dof = dimension * a + i
            force, own, mean = 0.0, 0.0, 0.0
            for row in range(9):
                half[dof, row] = 0.0
            for j in range(operator.counts[i]):
                g, row = weight * tables.gradients[e, q, a, j], operator.rows[i, j]
                force += g * v[FORCE, row]
                own += g * v[OWN, row]
                mean += g * v[MEAN, row]
                for column in range(9):
                    half[dof, column] += g * b[row, column]
            forces[e, dof] -= force
            scratch.a[dof] = own + 0.5 * weight * n * scratch.means[q, dof]
            scratch.b[dof] = mean + 0.5 * weight * n * scratch.means[q, dof]
    for dof in range(dimension * nodes):
        mean = scratch.means[q, dof]
        for a in range(nodes):
            for i in range(dimension):
                other = dimension * a + i
                total = scratch.a[dof] * scratch.means[q, other] + mean * scratch.b[other]
                for j in range(operator.counts[i]):
                    total += half[dof, operator.rows[i, j]] * tables.gradients[e, q, a, j]
                matrices[e, dof, other] += total

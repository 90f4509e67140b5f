"""Stiffness of linear elasticity with three planes of symmetry, in the axes of the material."""

import math
from typing import NamedTuple

from core_models.compilation import inside_kernel
from core_models.tensors import symmetric_inverse

LEAST_SINE = 1e-6  # between two axes that span a plane


class Stiffness(NamedTuple):
    """S = C : E in the axes of the material: nine constants and the axes.

    normal : C_11, C_22, C_33, C_12, C_23, C_31 [Pa]. shear : G_12, G_23, G_31 [Pa]. axes : rotation whose columns are
    the axes of the material in the reference body (nine components, row by row).
    """

    normal: tuple
    shear: tuple
    axes: tuple


@inside_kernel
def stressed(stiffness, strain):
    """Stress [Pa] of a strain, both symmetric tensors in the axes of the material."""
    c, g = stiffness.normal, stiffness.shear
    return (
        c[0] * strain[0] + c[3] * strain[1] + c[5] * strain[2],
        c[3] * strain[0] + c[1] * strain[1] + c[4] * strain[2],
        c[5] * strain[0] + c[4] * strain[1] + c[2] * strain[2],
        2.0 * g[0] * strain[3],
        2.0 * g[1] * strain[4],
        2.0 * g[2] * strain[5],
    )


@inside_kernel
def inverse_compliance(young, poisson):
    """C_11, C_22, C_33, C_12, C_23, C_31 [Pa] of E_1, E_2, E_3 [Pa] and nu_12, nu_23, nu_13 [-]."""
    over = (1.0 / young[0], 1.0 / young[1], 1.0 / young[2])
    return symmetric_inverse((*over, -poisson[0] * over[0], -poisson[1] * over[1], -poisson[2] * over[0]))


@inside_kernel
def material_axes(first, second):
    """The rotation whose columns are `first`, the part of `second` normal to it, and their cross product, unit each."""
    over = 1.0 / math.sqrt(dot(first, first))
    a = (over * first[0], over * first[1], over * first[2])
    along = dot(a, second)
    b = (second[0] - along * a[0], second[1] - along * a[1], second[2] - along * a[2])
    over = 1.0 / math.sqrt(dot(b, b))
    b = (over * b[0], over * b[1], over * b[2])
    c = cross(a, b)
    return (a[0], b[0], c[0], a[1], b[1], c[1], a[2], b[2], c[2])


@inside_kernel
def averaged_moduli(stiffness):
    """Bulk and shear modulus [Pa] averaged over all directions at equal strain, after Voigt."""
    c, g = stiffness.normal, stiffness.shear
    direct, coupling = c[0] + c[1] + c[2], c[3] + c[4] + c[5]
    return (direct + 2.0 * coupling) / 9.0, (direct - coupling + 3.0 * (g[0] + g[1] + g[2])) / 15.0


@inside_kernel
def largest_modulus(stiffness):
    """An upper bound of rho_0 c^2 [Pa] of all waves in the undeformed body; K + 4/3 G if isotropic with K >= 2/3 G.

    The largest eigenvalue of C after t (E_ij^2 - E_ii E_jj) with t = 2 max(C_ij, 0) was added to E : C : E for each
    pair of axes: of the strain of a wave, sym(a n), no such term is negative. Off-diagonal C_ij < 0 after Gershgorin.
    """
    c, g = stiffness.normal, stiffness.shear
    low = (max(-c[3], 0.0), max(-c[4], 0.0), max(-c[5], 0.0))
    direct = max(c[0] + low[0] + low[2], c[1] + low[0] + low[1], c[2] + low[1] + low[2])
    sheared = max(2.0 * g[0] + max(c[3], 0.0), 2.0 * g[1] + max(c[4], 0.0), 2.0 * g[2] + max(c[5], 0.0))
    return max(direct, sheared)


@inside_kernel
def dot(a, b):
    """Scalar product of two vectors."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@inside_kernel
def cross(a, b):
    """Vector product of two vectors."""
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def axes_fault(first: tuple, second: tuple) -> str:
    """What is wrong with two axes: no direction, or the same one; empty if nothing is."""
    spanned, lengths = math.hypot(*cross(first, second)), math.hypot(*first) * math.hypot(*second)
    if spanned > LEAST_SINE * lengths:
        return ""
    return "axis_1 and axis_2 span no plane: give two vectors that are neither 0 nor parallel"


def poisson_fault(young: tuple, poisson: tuple) -> str:
    """What makes a stiffness of E_1, E_2, E_3 and nu_12, nu_23, nu_13 not positive definite; empty if nothing does."""
    for name, ratio, i, j in zip(("nu_12", "nu_23", "nu_13"), poisson, (0, 1, 0), (1, 2, 2), strict=True):
        limit = math.sqrt(young[i] / young[j])
        if not abs(ratio) < limit:
            return (
                f"{name} = {ratio!r} makes a stiffness that is not positive definite: give it between "
                f"-{limit:.4g} and {limit:.4g}, the square root of E_{i + 1} / E_{j + 1}"
            )
    a, b, c = (
        ratio * math.sqrt(young[j] / young[i])
        for ratio, i, j in zip(poisson, (0, 1, 0), (1, 2, 2), strict=True)
    )
    determinant = 1.0 - a * a - b * b - c * c - 2.0 * a * b * c
    if not determinant > 0.0:
        return (
            f"Poisson's ratios together make a stiffness that is not positive definite (1 - nu_12 nu_21 - ... = "
            f"{determinant:.4g}): give smaller ones"
        )
    return ""

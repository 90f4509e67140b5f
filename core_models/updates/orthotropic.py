"""Anisotropic linear elasticity: orthotropic, transversely isotropic or cubic, in any orientation."""

import math
from typing import NamedTuple

from core_models.compilation import inside_kernel
from core_models.laws import advance_rows
from core_models.rows import F0, F1, LENGTH, STRESS, get, get_tensor, put_symmetric
from core_models.status import INVERTED, OK
from core_models.tensors import (
    congruence,
    contract,
    determinant,
    deviator,
    equivalent_stress,
    mean,
    plus_isotropic,
    product_transposed,
    scaled,
    symmetric_part,
    transposed_product,
)
from core_models.updates.balance import put_balance
from core_models.updates.compressible_neo_hookean import TWO_THIRDS, Deformed, balance

SQUARE_ANGLE = 1e-6  # cosine between the axes up to which they are perpendicular


class Orthotropic(NamedTuple):
    """Orthotropic elasticity, linear between Green-Lagrange strain and second Piola-Kirchhoff stress.

        S = C : E,   E = (F^T F - 1) / 2,   sigma = F S F^T / J,   W = E : C : E / 2

    In the axes of the material S_11 = C_11 E_11 + C_12 E_22 + C_31 E_33 and so on; S_23 = 2 C_44 E_23,
    S_31 = 2 C_55 E_31, S_12 = 2 C_66 E_12. Transversely isotropic about axis 1: C_22 = C_33, C_12 = C_31, C_55 = C_66,
    C_44 = (C_22 - C_23) / 2; cubic: C_11 = C_22 = C_33, C_12 = C_23 = C_31, C_44 = C_55 = C_66.

    Parameters
    ----------
    C_11, C_22, C_33, C_44, C_55, C_66 : stiffness [Pa], > 0. C_12, C_23, C_31 : stiffness across [Pa]; together
    positive definite.
    axis_1, axis_2 : directions of two axes in the reference body, perpendicular, of any length but 0; in axisymmetry
    their components are r, z, hoop.

    The moduli of the material's `elasticity` are Voigt's averages of the stiffness:

        K = [C_11 + C_22 + C_33 + 2 (C_12 + C_23 + C_31)] / 9
        G = [C_11 + C_22 + C_33 - C_12 - C_23 - C_31 + 3 (C_44 + C_55 + C_66)] / 15

    Valid for every rotation and moderate strain: the law softens in strong compression, and loses its stiffness where a
    free body is shortened to 1 / sqrt(3) of its length. Exact at the end of each step. In axisymmetry and plane strain
    an axis must be normal to the plane. The wave speed is an upper bound.
    Source: Bonet & Wood, Nonlinear Continuum Mechanics (2008), section 6.4; Voigt, Lehrbuch der Kristallphysik (1910).
    """

    C_11: float
    C_22: float
    C_33: float
    C_12: float
    C_23: float
    C_31: float
    C_44: float
    C_55: float
    C_66: float
    axis_1: tuple[float, float, float]
    axis_2: tuple[float, float, float]

    def fault(self) -> str:
        """What is wrong with the parameters taken together; empty if nothing is."""
        first, second = math.hypot(*self.axis_1), math.hypot(*self.axis_2)
        across = sum(a * b for a, b in zip(self.axis_1, self.axis_2, strict=True))
        if not abs(across) < SQUARE_ANGLE * first * second:
            return "axis_1 and axis_2 are not perpendicular: give two directions at a right angle"
        minor = self.C_11 * self.C_22 - self.C_12**2
        whole = (
            self.C_33 * minor
            - self.C_11 * self.C_23**2
            - self.C_22 * self.C_31**2
            + 2.0 * self.C_12 * self.C_23 * self.C_31
        )
        if not (minor > 0.0 and whole > 0.0):
            return "the stiffness is not positive definite: lower C_12, C_23 or C_31"
        return ""

    @property
    def directions(self) -> tuple:
        """The directions that the law knows."""
        return self.axis_1, self.axis_2

    @property
    def averages(self) -> tuple[float, float]:
        """Voigt's averages of bulk and shear modulus [Pa]."""
        along, across = self.C_11 + self.C_22 + self.C_33, self.C_12 + self.C_23 + self.C_31
        return (along + 2.0 * across) / 9.0, (
            along - across + 3.0 * (self.C_44 + self.C_55 + self.C_66)
        ) / 15.0


@inside_kernel
def towards_axes(law, f):
    """F Q^T: the deformation gradient with its second index in the axes of the material."""
    x, y = law.axis_1, law.axis_2
    p = 1.0 / math.sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2])
    q = 1.0 / math.sqrt(y[0] * y[0] + y[1] * y[1] + y[2] * y[2])
    x, y = (p * x[0], p * x[1], p * x[2]), (q * y[0], q * y[1], q * y[2])
    z = (x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0])
    return product_transposed(f, (x[0], x[1], x[2], y[0], y[1], y[2], z[0], z[1], z[2]))


@inside_kernel
def stiffened(law, strain):
    """C : E, both in the axes of the material."""
    return (
        law.C_11 * strain[0] + law.C_12 * strain[1] + law.C_31 * strain[2],
        law.C_12 * strain[0] + law.C_22 * strain[1] + law.C_23 * strain[2],
        law.C_31 * strain[0] + law.C_23 * strain[1] + law.C_33 * strain[2],
        2.0 * law.C_66 * strain[3],
        2.0 * law.C_44 * strain[4],
        2.0 * law.C_55 * strain[5],
    )


@inside_kernel
def green_lagrange(f):
    """Strain (F^T F - 1) / 2."""
    return scaled(plus_isotropic(symmetric_part(transposed_product(f, f)), -1.0), 0.5)


@inside_kernel
def largest_stiffness(law):
    """Upper bound of m (x) n : C : m (x) n over unit vectors [Pa]: C_12's like, which acts on (m.n)^2 <= 1, and the
    largest sum of a row of what is left; exact for isotropic stiffness.
    """
    base = max(min(law.C_12, law.C_23, law.C_31), 0.0)
    one, two, three = law.C_12 - base, law.C_23 - base, law.C_31 - base
    rows = max(
        law.C_11 - base + abs(one) + abs(three),
        law.C_22 - base + abs(one) + abs(two),
        law.C_33 - base + abs(two) + abs(three),
    )
    return base + max(rows, 2.0 * max(law.C_44, law.C_55, law.C_66))


@inside_kernel
def oriented(law, f):
    """Stress, energy and stiffness at a deformation gradient."""
    j = determinant(f)
    f = towards_axes(law, f)
    strain = green_lagrange(f)
    carried = stiffened(law, strain)
    tau = congruence(f, carried)
    b = symmetric_part(product_transposed(f, f))
    stretched = mean(b) + TWO_THIRDS * equivalent_stress(deviator(b))
    pulled = mean(tau) + TWO_THIRDS * equivalent_stress(deviator(tau))
    modulus = max(pulled, 0.0) + largest_stiffness(law) * stretched * stretched
    return Deformed(j, scaled(tau, 1.0 / j), 0.5 * contract(strain, carried), modulus)


@advance_rows.register(Orthotropic)
def _(update, rows, statuses, count, model, viscosity, dt):
    for k in range(count):
        before = oriented(update, get_tensor(rows, F0, k))
        after = oriented(update, get_tensor(rows, F1, k))
        statuses[k] = OK if after.volume_ratio > 0.0 else INVERTED
        put_symmetric(rows, STRESS, k, after.stress)
        put_balance(rows, k, balance(model, viscosity, before, after, dt, get(rows, LENGTH, k)))

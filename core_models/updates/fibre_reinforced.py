"""Fibre-reinforced neo-Hookean elasticity: a matrix and one family of fibres that carry tension."""

import math
from typing import NamedTuple

from core_models.compilation import inside_kernel
from core_models.rows import F0, F1, LENGTH, STRESS, get, get_tensor, put_symmetric
from core_models.status import INVERTED, OK
from core_models.tensors import plus, scaled
from core_models.updates.balance import put_balance
from core_models.updates.compressible_neo_hookean import Deformed, balance, deformed
from core_models.updates.interface import advance_rows


class FibreReinforced(NamedTuple):
    """Fibre-reinforced neo-Hookean elasticity: transversely isotropic, and stiffer the more the fibres are stretched.

        W = W_matrix(F) + k1 / (2 k2) {exp[k2 (I_4 - 1)^2] - 1} where I_4 > 1,   I_4 = a.a,   a = F fibre
        tau = tau_matrix + 2 k1 (I_4 - 1) exp[k2 (I_4 - 1)^2] a (x) a

    The matrix is that of `CompressibleNeoHookean` with the moduli of the material's `elasticity`; fibres that are
    compressed carry nothing.

    Parameters
    ----------
    k1 : stiffness of the fibres [Pa], > 0. k2 : how fast they stiffen [-], >= 0 (0: energy quadratic in I_4 - 1).
    fibre : direction in the reference body, of any length but 0; in axisymmetry its components are r, z, hoop.

    Valid for every J > 0 and every rotation in a step; exact at the end of each step. In axisymmetry and plane strain
    the fibres must lie in the plane or be normal to it. The wave speed is an upper bound.
    Source: Holzapfel, Gasser & Ogden, J. Elast. 61 (2000) 1.
    """

    k1: float
    k2: float
    fibre: tuple[float, float, float]

    def fault(self) -> str:
        """What is wrong with the parameters taken together; empty if nothing is."""
        return "" if any(self.fibre) else "the fibre has no direction: give a vector that is not 0"


class Stretched(NamedTuple):
    """Fibres: a (three components), I_4 - 1 where positive, and dW/dI_4 and d2W/dI_4^2 [Pa]."""

    vector: tuple
    excess: float
    slope: float
    curvature: float


@inside_kernel
def stretched(law, f):
    """The fibres at a deformation gradient."""
    x, y, z = law.fibre
    over = 1.0 / math.sqrt(x * x + y * y + z * z)
    x, y, z = over * x, over * y, over * z
    a = (f[0] * x + f[1] * y + f[2] * z, f[3] * x + f[4] * y + f[5] * z, f[6] * x + f[7] * y + f[8] * z)
    excess = max(a[0] * a[0] + a[1] * a[1] + a[2] * a[2] - 1.0, 0.0)
    square = law.k2 * excess * excess
    stiffness = law.k1 * math.exp(square) if excess > 0.0 else 0.0
    return Stretched(a, excess, stiffness * excess, stiffness * (1.0 + 2.0 * square))


@inside_kernel
def dyad(a):
    """Symmetric tensor a (x) a."""
    return (a[0] * a[0], a[1] * a[1], a[2] * a[2], a[0] * a[1], a[1] * a[2], a[2] * a[0])


@inside_kernel
def reinforced(law, model, f):
    """Stress, energy and stiffness of matrix and fibres."""
    matrix, fibres = deformed(model, f), stretched(law, f)
    square = fibres.excess * fibres.excess
    stored = 0.5 * law.k1 * (math.expm1(law.k2 * square) / law.k2 if law.k2 > 0.0 else square)
    length = fibres.excess + 1.0
    return Deformed(
        matrix.volume_ratio,
        plus(matrix.stress, scaled(dyad(fibres.vector), 2.0 * fibres.slope / matrix.volume_ratio)),
        matrix.energy + stored,
        matrix.modulus + 2.0 * fibres.slope * length + 4.0 * fibres.curvature * length * length,
    )


@advance_rows.register(FibreReinforced)
def _(update, rows, statuses, count, model, viscosity, dt):
    for k in range(count):
        before = reinforced(update, model, get_tensor(rows, F0, k))
        after = reinforced(update, model, get_tensor(rows, F1, k))
        statuses[k] = OK if after.volume_ratio > 0.0 else INVERTED
        put_symmetric(rows, STRESS, k, after.stress)
        put_balance(rows, k, balance(model, viscosity, before, after, dt, get(rows, LENGTH, k)))

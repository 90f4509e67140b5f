"""Compressible neo-Hookean elasticity: a stress that follows from the deformation gradient alone."""

import math
from typing import NamedTuple

from core_models.bulk_viscosity import viscous_pressure
from core_models.compilation import inside_kernel
from core_models.elementary import logarithm
from core_models.laws import elastic_moduli
from core_models.rows import F0, F1, LENGTH, STRESS, get, get_tensor, put_symmetric
from core_models.status import INVERTED, OK
from core_models.tensors import (
    determinant,
    deviator,
    equivalent_stress,
    mean,
    plus_isotropic,
    product_transposed,
    scaled,
    symmetric_part,
    trace,
)
from core_models.updates.balance import Balance, put_balance
from core_models.updates.interface import advance_rows

TWO_THIRDS = 2.0 / 3.0


class CompressibleNeoHookean(NamedTuple):
    """Compressible neo-Hookean elasticity, not split into a change of shape and one of volume.

        P = mu (F - F^-T) + lambda ln J F^-T,   sigma = [mu (b - 1) + lambda ln J 1] / J,   b = F F^T
        W = mu/2 (tr b - 3) - mu ln J + lambda/2 ln^2 J

    mu = G and lambda = K - 2 G / 3 are those of the material's `elasticity`; the mean stress depends on b, so it has
    no equation of state, and no effect of plastic flow or heat acts on it.

    Valid for every J > 0 and every rotation in a step; exact at the end of each step, whatever its size. Waves along n
    have the acoustic tensor rho_0 A = mu b_nn 1 + [mu + lambda (1 - ln J)] n n; the wave speed is that of the fastest,
    with an upper bound of b_nn that is exact where the two smaller stretches are equal.
    Source: Simo & Pister, CMAME 46 (1984) 201; Bonet & Wood, Nonlinear Continuum Mechanics (2008), eqs. 6.27, 6.29.
    """


@advance_rows.register(CompressibleNeoHookean)
def _(update, rows, statuses, count, model, viscosity, dt):
    for k in range(count):
        before = deformed(model, get_tensor(rows, F0, k))
        after = deformed(model, get_tensor(rows, F1, k))
        statuses[k] = OK if after.volume_ratio > 0.0 else INVERTED
        put_symmetric(rows, STRESS, k, after.stress)
        put_balance(rows, k, balance(model, viscosity, before, after, dt, get(rows, LENGTH, k)))


class Deformed(NamedTuple):
    """What a deformation gradient means: J [-], Cauchy stress (six components) [Pa], stored energy [J/m^3] and
    rho_0 c^2 [Pa], the last two per reference volume.
    """

    volume_ratio: float
    stress: tuple
    energy: float
    modulus: float


@inside_kernel
def deformed(model, f):
    """Stress, energy and stiffness at a deformation gradient."""
    bulk, shear = elastic_moduli(model.elasticity)
    lame = bulk - TWO_THIRDS * shear
    j = determinant(f)
    log_j = logarithm(j)
    strain = plus_isotropic(symmetric_part(product_transposed(f, f)), -1.0)
    stress = scaled(plus_isotropic(scaled(strain, shear), lame * log_j), 1.0 / j)
    energy = shear * (0.5 * trace(strain) - log_j) + 0.5 * lame * log_j * log_j
    largest = mean(strain) + TWO_THIRDS * equivalent_stress(deviator(strain))
    modulus = shear * (1.0 + largest) + max(shear + lame * (1.0 - log_j), 0.0)
    return Deformed(j, stress, energy, modulus)


@inside_kernel
def balance(model, viscosity, before, after, dt, length):
    """What a step did: the work of the stress is the change of the stored energy."""
    j0, j1 = before.volume_ratio, after.volume_ratio
    speed = math.sqrt(after.modulus / model.density)
    q = viscous_pressure(viscosity, model.density / j1, length, speed, 2.0 * (j1 - j0) / (dt * (j0 + j1)))
    return Balance(speed, q, after.energy - before.energy, 0.0, -q * (j1 - j0))

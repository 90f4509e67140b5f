"""St. Venant-Kirchhoff elasticity: linear in Green's strain, isotropic or not."""

from typing import NamedTuple

from core_models.compilation import inside_kernel
from core_models.elasticity.stiffness import largest_modulus, stressed
from core_models.laws import stiffness
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
    product,
    product_transposed,
    scaled,
    symmetric_part,
    transposed_product,
)
from core_models.updates.balance import put_balance
from core_models.updates.compressible_neo_hookean import TWO_THIRDS, Deformed, balance
from core_models.updates.interface import advance_rows


class StVenantKirchhoff(NamedTuple):
    """St. Venant-Kirchhoff elasticity: stress linear in Green's strain, with any stiffness of the slot `elasticity`.

        W = E : C : E / 2,   S = C : E,   E = (F^T F - 1) / 2,   P = F S,   sigma = F S F^T / J

    C is that of an isotropic, cubic, transversely isotropic or orthotropic elasticity, turned to its axes in the
    reference body; no effect of plastic flow or heat acts on the stress.

    Valid for every rotation in a step and strains of some 10 %; exact at the end of each step, whatever its size. In
    compression it softens: under uniaxial strain the load is largest at the stretch 1/sqrt(3) and falls to 0 with it.
    The wave speed is an upper bound.
    Source: Holzapfel, Nonlinear Solid Mechanics (2000), section 6.5; Bonet & Wood, Nonlinear Continuum Mechanics
    (2008), section 6.3.
    """


@inside_kernel
def stretched_axes(elastic, f):
    """F R, whose columns are the images of the axes of the material, and Green's strain in these axes."""
    g = product(f, elastic.axes)
    return g, scaled(plus_isotropic(symmetric_part(transposed_product(g, g)), -1.0), 0.5)


@inside_kernel
def strained(elastic, f):
    """Stress, energy and stiffness at a deformation gradient.

    Waves along n have the acoustic tensor rho_0 A = F C(F^T n, F^T n) F^T + tau_nn 1, with |F^T n|^2 = b_nn.
    """
    j = determinant(f)
    g, strain = stretched_axes(elastic, f)
    stress = stressed(elastic, strain)
    tau = congruence(g, stress)
    stretch = largest_value(symmetric_part(product_transposed(f, f)))
    modulus = stretch * stretch * largest_modulus(elastic) + max(largest_value(tau), 0.0)
    return Deformed(j, scaled(tau, 1.0 / j), 0.5 * contract(stress, strain), modulus)


@inside_kernel
def largest_value(s):
    """An upper bound of the largest principal value of a symmetric tensor; it where the two others are equal."""
    return mean(s) + TWO_THIRDS * equivalent_stress(deviator(s))


@advance_rows.register(StVenantKirchhoff)
def _(update, rows, statuses, count, model, viscosity, dt):
    elastic = stiffness(model.elasticity)
    for k in range(count):
        before = strained(elastic, get_tensor(rows, F0, k))
        after = strained(elastic, get_tensor(rows, F1, k))
        statuses[k] = OK if after.volume_ratio > 0.0 else INVERTED
        put_symmetric(rows, STRESS, k, after.stress)
        put_balance(rows, k, balance(model, viscosity, before, after, dt, get(rows, LENGTH, k)))

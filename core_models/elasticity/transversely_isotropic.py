"""Transversely isotropic linear elasticity."""

from typing import NamedTuple

from core_models.elasticity.stiffness import (
    Stiffness,
    averaged_moduli,
    inverse_compliance,
    material_axes,
    poisson_fault,
)
from core_models.laws import elastic_moduli, stiffness


class TransverselyIsotropicElastic(NamedTuple):
    """Transversely isotropic linear elasticity: one axis, 1, and the same in all directions normal to it.

    As orthotropic elasticity with E_3 = E_2, nu_13 = nu_12, G_13 = G_12 and G_23 = E_2 / (2 (1 + nu_23)).

    Parameters
    ----------
    E_1, E_2 : Young's moduli along and across the axis [Pa], > 0. G_12 : shear modulus along it [Pa], > 0.
    nu_12 : contraction across over extension along the axis under tension along it [-], |nu_12| < sqrt(E_1 / E_2).
    nu_23 : Poisson's ratio within the plane normal to it [-], between -1 and 1 - 2 nu_12^2 E_2 / E_1.
    axis : direction in the reference body, of any length but 0; in axisymmetry its components are r, z, hoop.

    With the updates StVenantKirchhoff and HypoelasticPlastic.
    In axisymmetry and plane strain the axis must lie in the plane or be normal to it.
    Source: Jones, Mechanics of Composite Materials (1999), section 2.3.
    """

    E_1: float
    E_2: float
    nu_12: float
    nu_23: float
    G_12: float
    axis: tuple[float, float, float]

    def fault(self) -> str:
        """What is wrong with the parameters taken together; empty if nothing is."""
        if not any(self.axis):
            return "the axis has no direction: give a vector that is not 0"
        return poisson_fault((self.E_1, self.E_2, self.E_2), (self.nu_12, self.nu_23, self.nu_12))


@stiffness.register(TransverselyIsotropicElastic)
def _(law):
    normal = inverse_compliance((law.E_1, law.E_2, law.E_2), (law.nu_12, law.nu_23, law.nu_12))
    shear = (law.G_12, law.E_2 / (2.0 + 2.0 * law.nu_23), law.G_12)
    x, y, z = law.axis
    across = (-y, x, 0.0) if abs(x) + abs(y) > abs(z) else (0.0, -z, y)
    return Stiffness(normal, shear, material_axes(law.axis, across))


@elastic_moduli.register(TransverselyIsotropicElastic)
def _(law):
    return averaged_moduli(stiffness(law))

"""Orthotropic linear elasticity."""

from typing import NamedTuple

from core_models.elasticity.stiffness import (
    Stiffness,
    averaged_moduli,
    axes_fault,
    inverse_compliance,
    material_axes,
    poisson_fault,
)
from core_models.laws import elastic_moduli, stiffness


class OrthotropicElastic(NamedTuple):
    """Orthotropic linear elasticity: three planes of symmetry, normal to the axes 1, 2, 3 of the material.

        e_11 = (s_11 - nu_12 s_22 - nu_13 s_33) / E_1,  ...,   e_12 = s_12 / (2 G_12),  ...,   nu_ij / E_i = nu_ji / E_j

    Parameters
    ----------
    E_1, E_2, E_3 : Young's moduli along the axes [Pa], > 0. G_12, G_23, G_13 : shear moduli [Pa], > 0.
    nu_12, nu_23, nu_13 : contraction along j over extension along i under tension along i [-], of size
    < sqrt(E_i / E_j); together they must leave the stiffness positive definite.
    axis_1, axis_2 : directions in the reference body, of any length but 0 and not parallel; of axis_2 the part normal
    to axis_1 counts, axis 3 is normal to both. In axisymmetry their components are r, z, hoop.

    With the updates StVenantKirchhoff and HypoelasticPlastic.
    In axisymmetry and plane strain one axis must be normal to the plane.
    Source: Lekhnitskii, Theory of Elasticity of an Anisotropic Body (1981), section 3; Jones, Mechanics of Composite
    Materials (1999), section 2.3.
    """

    E_1: float
    E_2: float
    E_3: float
    nu_12: float
    nu_23: float
    nu_13: float
    G_12: float
    G_23: float
    G_13: float
    axis_1: tuple[float, float, float]
    axis_2: tuple[float, float, float]

    def fault(self) -> str:
        """What is wrong with the parameters taken together; empty if nothing is."""
        young, poisson = (self.E_1, self.E_2, self.E_3), (self.nu_12, self.nu_23, self.nu_13)
        return poisson_fault(young, poisson) or axes_fault(self.axis_1, self.axis_2)


@stiffness.register(OrthotropicElastic)
def _(law):
    normal = inverse_compliance((law.E_1, law.E_2, law.E_3), (law.nu_12, law.nu_23, law.nu_13))
    return Stiffness(normal, (law.G_12, law.G_23, law.G_13), material_axes(law.axis_1, law.axis_2))


@elastic_moduli.register(OrthotropicElastic)
def _(law):
    return averaged_moduli(stiffness(law))

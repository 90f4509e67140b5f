"""Isotropic linear elasticity."""

from typing import NamedTuple, Self

from core_models.elasticity.stiffness import Stiffness
from core_models.errors import MaterialError
from core_models.laws import elastic_moduli, stiffness
from core_models.tensors import IDENTITY


class IsotropicElastic(NamedTuple):
    """Isotropic linear elasticity: s = 2 G dev(e); the pressure comes from the equation of state.

    Parameters
    ----------
    bulk_modulus : K [Pa], > 0. shear_modulus : G [Pa], > 0.

    In the hypoelastic update e is the unrotated elastic strain (rate form), in the hyperelastic one the deviator of
    the isochoric elastic left Cauchy-Green tensor (Simo & Hughes, Computational Inelasticity, 1998, ch. 9). The
    compressible neo-Hookean law takes the two moduli alone; St. Venant-Kirchhoff elasticity has
    S = (K - 2 G / 3) tr(E) 1 + 2 G E.
    """

    bulk_modulus: float
    shear_modulus: float

    @classmethod
    def from_young(cls, youngs_modulus: float, poissons_ratio: float) -> Self:
        """K = E / (3 (1 - 2 nu)), G = E / (2 (1 + nu)) from Young's modulus E [Pa], > 0, and -1 < nu < 1/2 [-].

        Raises MaterialError outside this range.
        """
        if not (youngs_modulus > 0.0 and -1.0 < poissons_ratio < 0.5):
            raise MaterialError(
                f"Young's modulus {youngs_modulus!r} Pa and Poisson's ratio {poissons_ratio!r} make no elastic solid: "
                "give E > 0 and -1 < nu < 0.5"
            )
        return cls(
            youngs_modulus / (3.0 - 6.0 * poissons_ratio), youngs_modulus / (2.0 + 2.0 * poissons_ratio)
        )


@elastic_moduli.register(IsotropicElastic)
def _(elasticity):
    return elasticity.bulk_modulus, elasticity.shear_modulus


@stiffness.register(IsotropicElastic)
def _(elasticity):
    bulk, shear = elasticity.bulk_modulus, elasticity.shear_modulus
    lame = bulk - 2.0 / 3.0 * shear
    direct = lame + 2.0 * shear
    return Stiffness((direct, direct, direct, lame, lame, lame), (shear, shear, shear), IDENTITY)

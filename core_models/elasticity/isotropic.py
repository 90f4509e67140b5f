"""Isotropic linear elasticity."""

from typing import NamedTuple

from core_models.laws import elastic_moduli


class IsotropicElastic(NamedTuple):
    """Isotropic linear elasticity: s = 2 G dev(e); the pressure comes from the equation of state.

    Parameters
    ----------
    bulk_modulus : K [Pa], > 0. shear_modulus : G [Pa], > 0.

    In the hypoelastic update e is the unrotated elastic strain (rate form), in the hyperelastic one the deviator of
    the isochoric elastic left Cauchy-Green tensor (Simo & Hughes, Computational Inelasticity, 1998, ch. 9).
    """

    bulk_modulus: float
    shear_modulus: float


@elastic_moduli.register(IsotropicElastic)
def _(elasticity):
    return elasticity.bulk_modulus, elasticity.shear_modulus

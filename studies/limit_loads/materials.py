"""Materials of the limit loads: elastic and perfectly plastic, stiff against their strength."""

import math
from typing import Any

from core_models.elasticity.isotropic import IsotropicElastic
from core_models.eos.default_hypo import DefaultHypoelastic
from core_models.flow.perfect import PerfectPlasticity
from core_models.material import Material
from core_models.updates.hypoelastic_plastic import HypoelasticPlastic
from core_models.yield_condition.drucker_prager import DruckerPrager
from core_models.yield_condition.mohr_coulomb import MohrCoulomb
from core_models.yield_condition.von_mises import VonMises

COHESION = 1e5  # Pa; limit loads are proportional to it
STIFFNESS = 10000.0  # Young's modulus over the cohesion
POISSON, DENSITY = 0.3, 2000.0


def perfectly_plastic(flow_stress: float, condition: Any, poisson: float = POISSON) -> Material:
    """Hypoelastic, with a constant flow stress [Pa]: of von Mises, or the cohesion of the other conditions."""
    young = STIFFNESS * COHESION
    bulk, shear = young / (3.0 * (1.0 - 2.0 * poisson)), young / (2.0 * (1.0 + poisson))
    return Material(
        "perfectly plastic", DENSITY, HypoelasticPlastic(), IsotropicElastic(bulk, shear),
        DefaultHypoelastic(bulk), PerfectPlasticity(flow_stress), condition,
    )  # fmt: skip


def von_mises(shear_strength: float) -> Material:
    """Von Mises' condition of a given strength in pure shear [Pa]."""
    return perfectly_plastic(math.sqrt(3.0) * shear_strength, VonMises())


def tresca(shear_strength: float) -> Material:
    """Tresca's condition: Mohr-Coulomb's without friction."""
    return perfectly_plastic(shear_strength, MohrCoulomb(0.0, 0.0))


def mohr_coulomb(friction: float) -> Material:
    """Mohr-Coulomb's condition of the cohesion COHESION and an angle of friction [degree], with associated flow."""
    return perfectly_plastic(COHESION, MohrCoulomb(friction, friction))


def drucker_prager(friction: float, fit: str) -> Material:
    """Drucker and Prager's cone that meets Mohr-Coulomb's pyramid by a fit of `DruckerPrager.from_friction`."""
    return perfectly_plastic(COHESION, DruckerPrager.from_friction(friction, friction, fit))

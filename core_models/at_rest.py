"""State and waves of points that have not been deformed."""

import numpy as np

from core_models.elasticity.stiffness import largest_modulus
from core_models.laws import (
    back_stress_count,
    elastic_moduli,
    pressure,
    stiffness,
    thermal_volume,
)
from core_models.material import Material, has_anisotropic_return
from core_models.state import State
from core_models.updates.hyperelastic_plastic import HyperelasticPlastic
from core_models.updates.hypoelastic_plastic import HypoelasticPlastic
from core_models.updates.st_venant_kirchhoff import StVenantKirchhoff


def initial_state(material: Material, n: int, temperature: float, conduction: bool = False) -> State:
    """State of n undeformed points at a temperature [K], with arrays only for what material or conduction need."""

    def scalar(needed: bool, value: float = 0.0) -> np.ndarray | None:
        return np.full(n, value) if needed else None

    hypo = isinstance(material.update, HypoelasticPlastic)
    hyper = isinstance(material.update, HyperelasticPlastic)
    variable = getattr(material.flow, "hardening_variable", None)
    voids = getattr(material.damage, "porosity_at_start", None)
    terms = back_stress_count(material.kinematic_hardening)
    stress = np.zeros((n, 6))
    stress[:, :3] = thermal_stress(material, temperature)
    return State(
        stress=stress,
        rotation=np.zeros((n, 3)) if hypo else None,
        elastic_left_cauchy_green=np.tile([1.0, 1.0, 1.0, 0.0, 0.0, 0.0], (n, 1)) if hyper else None,
        equivalent_plastic_strain=scalar(material.flow is not None),
        hardening_variable=scalar(variable is not None, variable or 0.0),
        temperature=scalar(material.needs_temperature or conduction, temperature),
        damage=scalar(material.damage is not None),
        internal_energy=scalar(material.uses("uses_energy")),
        plastic_volume=scalar(getattr(material.yield_condition, "has_plastic_volume", False)),
        porosity=scalar(voids is not None, voids or 0.0),
        back_stress=np.zeros((n, 6 * terms)) if terms else None,
    )


def thermal_stress(material: Material, temperature: float) -> float:
    """Mean stress [Pa] of the undeformed body at a temperature [K]: not zero only with thermal expansion."""
    if material.expansion is None:
        return 0.0
    return pressure(material.eos, 1.0 / thermal_volume(material.expansion, temperature), 0.0)[0]


def initial_wave_speed(material: Material) -> float:
    """Longitudinal wave speed of the unstressed material [m/s]."""
    if isinstance(material.update, StVenantKirchhoff) or has_anisotropic_return(material):
        return float(np.sqrt(largest_modulus(stiffness(material.elasticity)) / material.density))
    shear = material.shear_at_rest(material.room_temperature)
    return float(np.sqrt((bulk_at_rest(material) + 4.0 / 3.0 * shear) / material.density))


def bulk_at_rest(material: Material) -> float:
    """Bulk modulus of the unstressed material [Pa]."""
    if material.eos is None:
        return elastic_moduli(material.elasticity)[0]
    return pressure(material.eos, 1.0, 0.0)[1]

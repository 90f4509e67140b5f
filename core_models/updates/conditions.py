"""What the laws feel at a point: density, pressure and melting temperature, all of them before the step."""

from core_models.compilation import inside_kernel
from core_models.flow import weakened as _  # noqa: F401
from core_models.laws import (
    eroded_stress,
    melting_temperature,
    shear_stiffness,
    strength_taken,
    under_pressure,
    weakened,
)
from core_models.tensors import mean

SHEAR = (0.0, 0.0, 0.0, 1.0, 0.0, 0.0)


@inside_kernel
def melting_before(material, point, volume_ratio):
    """Melting temperature [K] at the state before the step, of volume ratio J; infinite without a melting law."""
    return melting_temperature(material.melting, 1.0 / volume_ratio, -mean(point.stress))


@inside_kernel
def flow_before(material, point, volume_ratio):
    """The flow law with the constants that it has there, and what damage and erosion leave of it.

    Laws that feel no pressure, in a material without damage, are what they are.
    """
    melting = melting_before(material, point, volume_ratio)
    flow = under_pressure(material.flow, 1.0 / volume_ratio, -mean(point.stress), melting)
    flow = weakened(material.damage, flow, 1.0 - strength_taken(material.damage, point.damage))
    return weakened(material.erosion, flow, carried_shear(material, point))


@inside_kernel
def carried_shear(material, point):
    """Share of its shear stress that erosion lets a point carry [-]."""
    return eroded_stress(material.erosion, point.damage, SHEAR, 0.0)[0][3]


@inside_kernel
def shear_before(material, point, volume_ratio):
    """Shear modulus [Pa] there."""
    melting = melting_before(material, point, volume_ratio)
    return shear_stiffness(
        material.shear_modulus, material.elasticity, 1.0 / volume_ratio, point.temperature, -mean(point.stress),
        melting,
    )  # fmt: skip

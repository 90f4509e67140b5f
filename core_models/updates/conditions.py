"""What the laws feel at a point: density, pressure and melting temperature, all of them before the step."""

from core_models.compilation import inside_kernel
from core_models.laws import melting_temperature, shear_stiffness, under_pressure
from core_models.tensors import mean


@inside_kernel
def melting_before(material, point, volume_ratio):
    """Melting temperature [K] at the state before the step, of volume ratio J; infinite without a melting law."""
    return melting_temperature(material.melting, 1.0 / volume_ratio, -mean(point.stress))


@inside_kernel
def flow_before(material, point, volume_ratio):
    """The flow law with the constants that it has there; laws that feel no pressure are what they are."""
    melting = melting_before(material, point, volume_ratio)
    return under_pressure(material.flow, 1.0 / volume_ratio, -mean(point.stress), melting)


@inside_kernel
def shear_before(material, point, volume_ratio):
    """Shear modulus [Pa] there."""
    melting = melting_before(material, point, volume_ratio)
    return shear_stiffness(
        material.shear_modulus, material.elasticity, 1.0 / volume_ratio, point.temperature, -mean(point.stress),
        melting,
    )  # fmt: skip

"""The plastic part of a step, the same for both stress updates."""

from core_models.compilation import inside_kernel
from core_models.laws import melting_temperature, return_to_surface
from core_models.status import OK
from core_models.tensors import equivalent_stress


@inside_kernel
def returned(material, trial, shear_3, deviator_before, dt, tolerance, point):
    """Return a trial deviator to the yield surface, or to zero where the point has melted.

    Returns
    -------
    (factor on the trial, increment of equivalent plastic strain, flow stress [Pa], hardening variable, status)
    """
    if point.temperature >= melting_temperature(material.melting):
        return 0.0, 0.0, 0.0, point.hardening_variable, OK
    return return_to_surface(
        material.yield_condition, material.flow, trial, shear_3, equivalent_stress(deviator_before),
        point.equivalent_plastic_strain, point.hardening_variable, dt, point.temperature, tolerance,
    )  # fmt: skip

"""What both stress updates share: pressure with energy and bulk viscosity, and heating with damage."""

import math
from typing import NamedTuple

from core_models.bulk_viscosity import viscous_pressure
from core_models.compilation import inside_kernel
from core_models.laws import damage_increment, eroded_stress, heat_capacity, heated_fraction, pressure

NO_STRESS = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


class Balance(NamedTuple):
    """What a step did at a point: wave speed [m/s], viscous pressure [Pa], and per reference volume [J/m^3] the work
    of the stress (viscosity apart), the plastic dissipation and the work of the viscosity."""

    wave_speed: float
    viscous_pressure: float
    stress_work: float
    plastic: float
    viscous: float


NOTHING = Balance(0.0, 0.0, 0.0, 0.0, 0.0)


class Pressure(NamedTuple):
    """Result of `advance_pressure`."""

    mean_stress: float
    energy: float
    bulk_modulus: float
    viscous: float
    work: float
    viscous_work: float


@inside_kernel
def advance_pressure(material, viscosity, j0, j1, dt, length, shear, deviatoric_work, point):
    """Mean stress at the end of the step, consistent with the energy that its own work adds.

    The energy balance de = s:d + (p - q) dJ by the trapezoidal rule is linear in the new mean stress because the
    equation of state is linear in e: solved in closed form. The bulk modulus is that at constant entropy.
    """
    p0 = (point.stress[0] + point.stress[1] + point.stress[2]) / 3.0
    density = material.density / j1
    change = j1 - j0
    cold, slope, by_energy = pressure(material.eos, j1, point.internal_energy)
    modulus = max(j1 * (slope + by_energy * cold), 0.0)
    speed = math.sqrt((modulus + 4.0 / 3.0 * shear) / density)
    q = viscous_pressure(viscosity, density, length, speed, 2.0 * change / (dt * (j0 + j1)))
    viscous_work = -q * change
    p1 = (cold + by_energy * (deviatoric_work + 0.5 * p0 * change + viscous_work)) / (1.0 - 0.5 * by_energy * change)
    p1 = eroded_stress(material.erosion, point.damage, NO_STRESS, p1)[1]
    work = 0.5 * (p0 + p1) * change
    energy = point.internal_energy + deviatoric_work + work + viscous_work
    return Pressure(p1, energy, modulus, q, work, viscous_work)


@inside_kernel
def heated(material, temperature, dissipation, viscous_work):
    """Temperature after the step: rho_0 c (T_1 - T_0) = fraction dissipation + viscous work, per reference volume."""
    fraction = heated_fraction(material.heating)
    if fraction == 0.0:
        return temperature
    heat = fraction * dissipation + viscous_work
    return temperature + heat / (material.density * heat_capacity(material.specific_heat, temperature))


@inside_kernel
def damaged(material, point, increment, dt, mean_stress, equivalent_stress):
    """Damage variable after the step."""
    return point.damage + damage_increment(
        material.damage, increment, increment / dt, point.temperature, mean_stress, equivalent_stress
    )

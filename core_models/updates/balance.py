"""What both stress updates share: pressure with energy and bulk viscosity, and heating with damage."""

import math
from typing import NamedTuple

from core_models.bulk_viscosity import viscous_pressure
from core_models.columns import put_point
from core_models.compilation import inside_kernel
from core_models.laws import (
    damage_after,
    damage_increment,
    elastic_moduli,
    eroded_stress,
    heat_capacity,
    heated_fraction,
    pressure,
    thermal_volume,
    volume_warming,
)
from core_models.rows import BALANCE, ROTATION_1, get, put, put_vector
from core_models.state import PointState
from core_models.tensors import mean, plus_isotropic, scaled
from core_models.updates.conditions import shear_before
from core_models.updates.interface import complete, stress_measure
from core_models.updates.prediction import NO_STRESS

FOUR_THIRDS = 4.0 / 3.0


class Balance(NamedTuple):
    """What a step did at a point: wave speed [m/s], viscous pressure [Pa], and per reference volume [J/m^3] the work
    of the stress (viscosity apart), the plastic dissipation and the work of the viscosity.
    """

    wave_speed: float
    viscous_pressure: float
    stress_work: float
    plastic: float
    viscous: float


class Pressure(NamedTuple):
    """Result of `advance_pressure`."""

    mean_stress: float
    energy: float
    wave_speed: float
    viscous: float
    work: float
    viscous_work: float


@inside_kernel
def advance_pressure(material, viscosity, prediction, dt, length, shear, deviatoric_work, point):
    """Mean stress at the end of the step, consistent with the energy that its own work adds.

    The energy balance de = s:d + (p - q) dJ by the trapezoidal rule is linear in the new mean stress because the
    equation of state is linear in e: solved in closed form. `shear` is the Cauchy-stress shear modulus; the wave
    speed is that of longitudinal waves at constant entropy.
    """
    p0 = mean(point.stress)
    j0, j1 = prediction.volume_ratio_0, prediction.volume_ratio_1
    change = j1 - j0
    cold, slope, by_energy = cold_pressure(material, j1, point.temperature, point.internal_energy)
    modulus = max(j1 * (slope + by_energy * cold), 0.0)
    speed = math.sqrt((modulus + FOUR_THIRDS * shear) * j1 * (1.0 / material.density))
    q = viscous_pressure(viscosity, material.density / j1, length, speed, 2.0 * change / (dt * (j0 + j1)))
    viscous_work = -q * change
    p1 = cold
    if by_energy != 0.0:
        added = deviatoric_work + 0.5 * p0 * change + viscous_work
        p1 = (cold + by_energy * added) / (1.0 - 0.5 * by_energy * change)
    p1 = eroded_stress(material.erosion, point.damage, NO_STRESS, p1)[1]
    work = 0.5 * (p0 + p1) * change
    energy = point.internal_energy + deviatoric_work + work + viscous_work
    return Pressure(p1, energy, speed, q, work, viscous_work)


@inside_kernel
def cold_pressure(material, volume_ratio, temperature, energy):
    """What `pressure` (core_models.laws) returns, for the volume that is left without thermal expansion."""
    over_expansion = 1.0 / thermal_volume(material.expansion, temperature)
    stress, slope, by_energy = pressure(material.eos, volume_ratio * over_expansion, energy)
    return stress, slope * over_expansion, by_energy


@inside_kernel
def complete_point(material, viscosity, prediction, correction, dt, length, point):
    """State after the step, and what the step did, from the prediction and the return to the yield surface."""
    j0, j1 = prediction.volume_ratio_0, prediction.volume_ratio_1
    deviator, deviatoric_work, elastic = complete(material.update, material, prediction, correction, point)
    to_cauchy = stress_measure(material.update, j1) / j1
    # The stable steps of the solvers know the card's modulus: the wave speed is not below that of it.
    shear = max(shear_before(material, point, j0), elastic_moduli(material.elasticity)[1]) * to_cauchy
    p = advance_pressure(material, viscosity, prediction, dt, length, shear, deviatoric_work, point)
    increment, flow_stress = correction.increment, correction.flow_stress
    dissipation = stress_measure(material.update, j1) * flow_stress * increment
    after = PointState(
        plus_isotropic(scaled(deviator, to_cauchy), p.mean_stress),
        point.rotation,
        elastic,
        point.equivalent_plastic_strain + increment,
        correction.hardening_variable,
        heated(material, point.temperature, dissipation, prediction.volume_ratio_0, j1),
        damaged(material, point, increment, dt, p.mean_stress, flow_stress * to_cauchy),
        p.energy,
    )
    return after, Balance(p.wave_speed, p.viscous, deviatoric_work + p.work, dissipation, p.viscous_work)


@inside_kernel
def left_behind(before):
    """State and balance of a point that is out of the simulation: nothing but its history stays."""
    after = PointState(
        NO_STRESS,
        before.rotation,
        before.elastic_left_cauchy_green,
        before.equivalent_plastic_strain,
        before.hardening_variable,
        before.temperature,
        before.damage,
        before.internal_energy,
    )
    return after, Balance(0.0, 0.0, 0.0, 0.0, 0.0)


@inside_kernel
def leave_behind(rows, k, before):
    """Write state and balance of a point that is out of the simulation."""
    point, balance = left_behind(before)
    put_vector(rows, ROTATION_1, k, before.rotation)
    put_point(rows, k, point)
    put_balance(rows, k, balance)


@inside_kernel
def heated(material, temperature, dissipation, before, after):
    """Temperature after the step: rho_0 c (T_1 - T_0) = fraction dissipation, per reference volume, and what the
    change of J from `before` to `after` adds.
    """
    heat = heated_fraction(material.heating) * dissipation
    capacity = material.density * heat_capacity(material.specific_heat, temperature)
    return temperature * volume_warming(material.heating, material.eos, before, after) + heat * (
        1.0 / capacity
    )


@inside_kernel
def damaged(material, point, increment, dt, mean_stress, equivalent_stress):
    """Damage variable after the step."""
    added = damage_increment(
        material.damage, increment, increment / dt, point.temperature, mean_stress, equivalent_stress
    )
    return damage_after(material.erosion, point.damage, added, dt)


@inside_kernel
def get_balance(rows, k):
    """What the step did at point k."""
    return Balance(
        get(rows, BALANCE, k), get(rows, BALANCE + 1, k), get(rows, BALANCE + 2, k),
        get(rows, BALANCE + 3, k), get(rows, BALANCE + 4, k),
    )  # fmt: skip


@inside_kernel
def put_balance(rows, k, balance):
    """Write what the step did at point k."""
    put(rows, BALANCE, k, balance.wave_speed)
    put(rows, BALANCE + 1, k, balance.viscous_pressure)
    put(rows, BALANCE + 2, k, balance.stress_work)
    put(rows, BALANCE + 3, k, balance.plastic)
    put(rows, BALANCE + 4, k, balance.viscous)

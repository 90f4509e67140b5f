"""State behind the front of a plane impact: elastic-perfectly plastic solid with a Mie-Grüneisen equation of state."""

import math
from typing import NamedTuple

from scipy.optimize import brentq

from core_models.eos.mie_gruneisen import MieGruneisen


class ShockState(NamedTuple):
    """Behind the plastic front: axial compressive stress and pressure [Pa], density [kg/m^3], speed of the front
    [m/s], specific energy [J/kg]; whether an elastic precursor runs ahead.
    """

    stress: float
    pressure: float
    density: float
    front_speed: float
    energy: float
    has_precursor: bool


def hydrodynamic_shock(eos: MieGruneisen, velocity: float) -> ShockState:
    """State of a fluid at particle velocity u: U = C_0 + S u, p = rho_0 U u, e = u^2 / 2."""
    speed = eos.C_0 + eos.S_alpha * velocity
    stress = eos.reference_density * speed * velocity
    density = eos.reference_density * speed / (speed - velocity)
    return ShockState(stress, stress, density, speed, 0.5 * velocity**2, False)


def elastic_limit(eos: MieGruneisen, shear: float, flow_stress: float) -> tuple[float, float, float]:
    """Hugoniot elastic limit: stress [Pa], particle velocity [m/s], speed of the precursor [m/s]; acoustic."""
    bulk = eos.reference_density * eos.C_0**2
    stress = flow_stress * (0.5 * bulk / shear + 2.0 / 3.0)
    speed = math.sqrt((bulk + 4.0 / 3.0 * shear) / eos.reference_density)
    return stress, stress / (eos.reference_density * speed), speed


def shock_state(eos: MieGruneisen, shear: float, flow_stress: float, velocity: float) -> ShockState:
    """State at particle velocity u [m/s] with shear modulus G and constant flow stress Y [Pa].

    Rankine-Hugoniot across the elastic precursor and across the plastic front behind it, s = p + 2 Y / 3:

        [s] = rho_1 (U - u_1) [u],  rho (U - u) = rho_1 (U - u_1),  [e] = (s + s_1) (1/rho_1 - 1/rho) / 2

    Where the plastic front would outrun the precursor there is only one front, from the rest state.
    """
    limit, speed, precursor = elastic_limit(eos, shear, flow_stress)
    density = eos.reference_density / (1.0 - speed / precursor)
    ahead = _Side(limit, speed, density, 0.5 * speed**2)
    found = _behind(eos, flow_stress, velocity, ahead)
    if found.front_speed < precursor:
        return found._replace(has_precursor=True)
    return _behind(eos, flow_stress, velocity, _Side(0.0, 0.0, eos.reference_density, 0.0))


class _Side(NamedTuple):
    stress: float
    velocity: float
    density: float
    energy: float


def _behind(eos: MieGruneisen, flow_stress: float, velocity: float, ahead: _Side) -> ShockState:
    """The state at `velocity` behind one front into the state `ahead`."""
    jump = velocity - ahead.velocity

    def state(stress: float) -> tuple[float, float, float]:
        relative = (stress - ahead.stress) / (ahead.density * jump)
        density = ahead.density * relative / (relative - jump)
        energy = ahead.energy + 0.5 * (stress + ahead.stress) * (1.0 / ahead.density - 1.0 / density)
        return relative, density, energy

    def imbalance(stress: float) -> float:
        _, density, energy = state(stress)
        return _pressure(eos, density, energy) + 2.0 / 3.0 * flow_stress - stress

    fluid = hydrodynamic_shock(eos, velocity).stress
    stress = brentq(imbalance, 0.7 * fluid, 1.5 * fluid, rtol=1e-14)
    relative, density, energy = state(stress)
    front = ahead.velocity + relative
    return ShockState(stress, stress - 2.0 / 3.0 * flow_stress, density, front, energy, False)


def _pressure(eos: MieGruneisen, density: float, energy: float) -> float:
    """Compressive pressure [Pa] at a density and a specific energy [J/kg], from the Hugoniot as reference curve."""
    strain = 1.0 - eos.reference_density / density
    hugoniot = eos.reference_density * eos.C_0**2 * strain / (1.0 - eos.S_alpha * strain) ** 2
    reference_energy = 0.5 * hugoniot * strain / eos.reference_density
    return hugoniot + eos.Gamma_0 * eos.reference_density * (energy - reference_energy)

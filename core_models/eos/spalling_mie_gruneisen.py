"""Mie-Grüneisen equation of state whose tension is cut off."""

from typing import NamedTuple

from core_models.eos.mie_gruneisen import MieGruneisen
from core_models.laws import is_beyond_eos, isentropic_ratio, pressure


class SpallingMieGruneisen(NamedTuple):
    """Mie-Grüneisen equation of state with a spall cut-off: mean stress min(p, spall_strength), p tension positive.

    p is that of `MieGruneisen`, with its linear tension branch.

    Parameters
    ----------
    reference_density, C_0, Gamma_0, S_alpha : those of `MieGruneisen`. spall_strength : largest mean stress in tension
    [Pa], > 0 (OFHC copper some 1.2 GPa).

    Variant: a cut-off without memory. Material that has opened carries spall_strength while it opens on, resists again
    where it closes at the volume that the equation of state gives, and what opening takes is internal energy.
    Valid as `MieGruneisen`. Source: the pressure cut-off of wave codes; Wilkins, Computer Simulation of Dynamic
    Phenomena (1999).
    """

    reference_density: float
    C_0: float
    Gamma_0: float
    S_alpha: float
    spall_strength: float

    uses_energy = True


@pressure.register(SpallingMieGruneisen)
def _(eos, volume_ratio, energy):
    whole = MieGruneisen(eos.reference_density, eos.C_0, eos.Gamma_0, eos.S_alpha)
    stress, slope, by_energy = pressure(whole, volume_ratio, energy)
    if stress > eos.spall_strength:
        return eos.spall_strength, 0.0, 0.0
    return stress, slope, by_energy


@isentropic_ratio.register(SpallingMieGruneisen)
def _(eos, before, after):
    return isentropic_ratio(
        MieGruneisen(eos.reference_density, eos.C_0, eos.Gamma_0, eos.S_alpha), before, after
    )


@is_beyond_eos.register(SpallingMieGruneisen)
def _(eos, volume_ratio):
    return is_beyond_eos(MieGruneisen(eos.reference_density, eos.C_0, eos.Gamma_0, eos.S_alpha), volume_ratio)

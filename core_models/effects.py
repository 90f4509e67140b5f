"""Which physical effects a material brings into a simulation, and why the others are absent."""

from typing import NamedTuple

from core_models.laws import under_pressure
from core_models.melting.constant import ConstantMelting

NOT_OFFERED = "the card gives none, and none is offered yet"


class Effect(NamedTuple):
    """One physical effect: whether it is simulated, and why."""

    name: str
    on: bool
    reason: str


def material_effects(m) -> list[Effect]:
    """Effects of a `Material`, on or off and why."""
    energy = m.eos if m.uses("uses_energy") else None
    volumetric = m.update if m.eos is None else m.eos
    softening = m.flow if getattr(m.flow, "uses_temperature", False) else None
    return [
        _effect("plasticity", m.flow, "the card has no flow law"),
        _effect("kinematic hardening", m.kinematic_hardening, NOT_OFFERED),
        _effect("temperature-dependent shear modulus", m.shear_modulus, NOT_OFFERED),
        _effect(
            "equation of state with energy",
            energy,
            f"{type(volumetric).__name__} does not depend on the energy",
        ),
        Effect("plastic heating", m.heating is not None, _heating_reason(m)),
        _effect("thermal softening", softening, "the flow law does not depend on the temperature"),
        *_under_pressure(m),
        _effect("melting", m.melting, "the card gives no melt_temp"),
        _effect("damage", m.damage, "the card has no damage model"),
        _effect(
            "erosion", m.erosion, "the card asks for none: damage is computed and reported, it does not act"
        ),
        _effect("loss of stability", m.stability, NOT_OFFERED),
    ]


def _effect(name: str, law: tuple | None, absent: str) -> Effect:
    reason = absent if law is None else f"the card asks for it ({type(law).__name__})"
    return Effect(name, law is not None, reason)


def _under_pressure(m) -> list[Effect]:
    """What laws that know of density and pressure do not get from the updates; nothing for other laws."""
    laws = {
        "strength under pressure": m.flow if type(m.flow) in under_pressure.implementations else None,
        "melting under pressure": None if isinstance(m.melting, ConstantMelting) else m.melting,
    }
    return [
        Effect(name, False, f"no update hands density and pressure to {type(law).__name__} yet: as at rest")
        for name, law in laws.items()
        if law is not None
    ]


def _heating_reason(m) -> str:
    if hasattr(m.heating, "fraction"):
        return f"{m.heating.fraction:g} of the plastic work becomes heat (taylor_quinney_coeff, default 0.9)"
    if m.heating is not None:
        return f"the card asks for it ({type(m.heating).__name__})"
    if m.flow is None:
        return "no plastic work: the card has no flow law"
    if m.specific_heat is None:
        return "the card gives no specific_heat"
    if not m.needs_temperature:
        return "no law of the card depends on the temperature"
    return "turned off by the scene or the card"

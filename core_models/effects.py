"""Which physical effects a material brings into a simulation, and why the others are absent."""

from typing import NamedTuple

from core_models.laws import under_pressure, volume_warming


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
    pressed = m.flow if type(m.flow) in under_pressure.implementations else None
    return [
        _effect("plasticity", m.flow, "the card has no flow law"),
        _effect("kinematic hardening", m.kinematic_hardening, "the card has no kinematic_hardening_model"),
        _effect(
            "variable shear modulus",
            m.shear_modulus,
            "the card gives no shear_modulus_model: it is constant",
        ),
        _effect(
            "equation of state with energy",
            energy,
            f"{type(volumetric).__name__} does not depend on the energy",
        ),
        Effect("plastic heating", m.heating is not None, _heating_reason(m)),
        _effect(
            "heat of volume change",
            m.heating if type(m.heating) in volume_warming.implementations else None,
            "the card asks for no isentropic heating",
        ),
        _effect("thermal expansion", m.expansion, "the card gives no coefficient of thermal expansion"),
        _effect("thermal softening", softening, "the flow law does not depend on the temperature"),
        _effect("strength under pressure", pressed, "the flow law does not depend on density and pressure"),
        _effect("melting", m.melting, "the card gives neither melt_temp nor melting_temp_model"),
        _effect("damage", m.damage, "the card has no damage model"),
        _effect("erosion", m.erosion, f"the card asks for none: {_acting(m)}"),
        _effect("loss of stability", m.stability, "the card asks for no stability_check"),
    ]


def _effect(name: str, law: tuple | None, absent: str) -> Effect:
    reason = absent if law is None else f"the card asks for it ({type(law).__name__})"
    return Effect(name, law is not None, reason)


def _acting(m) -> str:
    if hasattr(m.damage, "porosity_at_start"):
        return "voids act through the yield condition"
    return "damage is computed and reported, it does not act"


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

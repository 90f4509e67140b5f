"""Which physical effects a material brings into a simulation, and why the others are absent."""

from typing import NamedTuple


class Effect(NamedTuple):
    """One physical effect: whether it is simulated, and why."""

    name: str
    on: bool
    reason: str


def material_effects(m) -> list[Effect]:
    """Effects of a `Material`, on or off and why."""
    softens = getattr(m.flow, "uses_temperature", False)
    return [
        Effect("plasticity", m.flow is not None, _why(m.flow, "the card has no flow law")),
        Effect(
            "equation of state with energy",
            m.uses("uses_energy"),
            _why(
                m.eos if m.uses("uses_energy") else None,
                f"{type(m.eos).__name__} does not depend on the energy",
            ),
        ),
        Effect(
            "plastic heating",
            m.heating is not None,
            _why(m.heating, "no law of the card depends on the temperature, or it gives no specific heat"),
        ),
        Effect(
            "thermal softening",
            softens,
            _why(m.flow if softens else None, "the flow law does not depend on the temperature"),
        ),
        Effect("melting", m.melting is not None, _why(m.melting, "the card gives no melt_temp")),
        Effect("damage", m.damage is not None, _why(m.damage, "the card has no damage model")),
        Effect(
            "erosion",
            m.erosion is not None,
            _why(m.erosion, "the card asks for none: damage is computed and reported, it does not act"),
        ),
    ]


def _why(law: tuple | None, absent: str) -> str:
    return absent if law is None else f"the card asks for it ({type(law).__name__})"

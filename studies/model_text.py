"""The material laws explained: from their docstrings and the card schema."""

import inspect
from collections.abc import Iterator

from core_models.elasticity.isotropic import IsotropicElastic
from core_models.errors import SceneError
from core_models.melting.constant import ConstantMelting
from core_models.names import suggestion
from core_models.schema import CONSTANTS, ELASTICITY, SLOTS, ModelSchema, SlotSchema
from core_models.specific_heat.constant import ConstantSpecificHeat
from studies.text_table import aligned

PLAIN_LAWS = {
    "elasticity": IsotropicElastic,
    "melting": ConstantMelting,
    "specific_heat": ConstantSpecificHeat,
}
"""Laws that a card gives by plain tags, without a block and a type."""


def model_list() -> str:
    """All laws by slot: card type, class, one line."""
    parts = [
        f"{slot}  by plain tags\n  {' '.join(f'<{p.tag}>' for p in model.parameters)}  {model.law.__name__}  "
        f"{_first_line(model)}"
        for slot, model in _plain_models()
    ]
    for slot in SLOTS:
        longest = max((len(model.law.__name__) for model in slot.models), default=0)
        rows = [
            [f"  {model.types[0]}", f"{model.law.__name__:<{longest}}  {_first_line(model)}"]
            for model in slot.models
        ]
        if rows:
            width = max(len(row[1]) for row in rows)
            parts.append(f"{slot.slot}  <{slot.tags[0]}>\n" + aligned([[a, b.ljust(width)] for a, b in rows]))
    return "\n\n".join(parts)


def find_models(name: str | None = None) -> list[tuple[str, ModelSchema]]:
    """Slots and schemas of all laws, or of those of a card type or class; SceneError naming the nearest one."""
    known = [(slot.slot, model) for slot, model in _models()] + list(_plain_models())
    found = [each for each in known if name is None or name in (*each[1].types, each[1].law.__name__)]
    if not found:
        valid = {word for _, model in known for word in (*model.types, model.law.__name__)}
        raise SceneError(f"no law '{name}'; {suggestion(name, valid)}")
    return found


def model_text(name: str) -> str:
    """Everything about the laws of that card type or class; raises SceneError naming the nearest one."""
    tags = {slot.slot: slot for slot in SLOTS}
    return "\n\n".join(
        _explained(tags[slot], model) if model.types else _told(slot, model, "plain tags")
        for slot, model in find_models(name)
    )


def _models() -> Iterator[tuple[SlotSchema, ModelSchema]]:
    return ((slot, model) for slot in SLOTS for model in slot.models)


def _plain_models() -> Iterator[tuple[str, ModelSchema]]:
    for slot, law in PLAIN_LAWS.items():
        tags = tuple(p for p in (*ELASTICITY, *CONSTANTS) if p.field.startswith(f"{slot}."))
        yield slot, ModelSchema((), law, "", tags)


def _first_line(model: ModelSchema) -> str:
    return (inspect.getdoc(model.law) or model.help).splitlines()[0].rstrip(":")


def _explained(slot: SlotSchema, model: ModelSchema) -> str:
    return _told(slot.slot, model, f'<{slot.tags[0]} {slot.attribute}="{model.types[0]}">')


def _told(slot: str, model: ModelSchema, card: str) -> str:
    head = f"{model.law.__name__}  (slot {slot}; module {model.law.__module__})"
    rows = [
        [f"  <{p.tag}>", f"[{p.unit}]".ljust(10), str(p.range).ljust(18), f"{p.help} ({p.requirement})"]
        for p in model.parameters
    ]
    width = max((len(row[3]) for row in rows), default=0)
    tags = aligned([[*row[:3], row[3].ljust(width)] for row in rows]) if rows else "  no tags"
    return f"{head}\n\n{inspect.getdoc(model.law)}\n\nIn a card: {card}\n{tags}"

"""The material laws explained: from their docstrings and the card schema."""

import inspect
from collections.abc import Iterator

from core_models.errors import SceneError
from core_models.schema import SLOTS, ModelSchema, SlotSchema
from studies.names import nearest
from studies.text_table import aligned


def model_list() -> str:
    """All laws by slot: card type, class, one line."""
    parts = []
    for slot in SLOTS:
        rows = [
            [f"  {model.types[0]}", f"{model.law.__name__:<24}{_first_line(model)}"] for model in slot.models
        ]
        if rows:
            width = max(len(row[1]) for row in rows)
            parts.append(f"{slot.slot}  <{slot.tags[0]}>\n" + aligned([[a, b.ljust(width)] for a, b in rows]))
    return "\n\n".join(parts)


def model_text(name: str) -> str:
    """Everything about the laws of that card type or class; raises SceneError naming the nearest one."""
    found = [
        _explained(slot, model) for slot, model in _models() if name in (*model.types, model.law.__name__)
    ]
    if not found:
        valid = {known for _, model in _models() for known in (*model.types, model.law.__name__)}
        raise SceneError(f"no law '{name}'; {nearest(name, valid)}")
    return "\n\n".join(found)


def _models() -> Iterator[tuple[SlotSchema, ModelSchema]]:
    return ((slot, model) for slot in SLOTS for model in slot.models)


def _first_line(model: ModelSchema) -> str:
    return (inspect.getdoc(model.law) or model.help).splitlines()[0].rstrip(":")


def _explained(slot: SlotSchema, model: ModelSchema) -> str:
    head = f"{model.law.__name__}  (slot {slot.slot}; module {model.law.__module__})"
    card = f'In a card: <{slot.tags[0]} {slot.attribute}="{model.types[0]}">'
    rows = [
        [f"  <{p.tag}>", f"[{p.unit}]".ljust(10), str(p.range).ljust(18), f"{p.help} ({p.requirement})"]
        for p in model.parameters
    ]
    width = max((len(row[3]) for row in rows), default=0)
    tags = aligned([[*row[:3], row[3].ljust(width)] for row in rows]) if rows else "  no tags"
    return f"{head}\n\n{inspect.getdoc(model.law)}\n\n{card}\n{tags}"

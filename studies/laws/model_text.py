"""The material laws explained: from their docstrings and the card schema."""

import difflib
import inspect
from collections.abc import Iterator

from core_models.elasticity.isotropic import IsotropicElastic
from core_models.errors import SceneError
from core_models.melting.constant import ConstantMelting
from core_models.names import ALIKE
from core_models.schema import CONSTANTS, ELASTICITY, SLOTS, ModelSchema, SlotSchema
from core_models.specific_heat.constant import ConstantSpecificHeat
from studies.output.text_table import aligned

PLAIN_LAWS = {
    "elasticity": IsotropicElastic,
    "melting": ConstantMelting,
    "specific_heat": ConstantSpecificHeat,
}
"""Laws that a card gives by plain tags, without a block and a type."""
BY_DEFAULT = {
    "constant_shear": "IsotropicElastic",
    "constant_Tm": "ConstantMelting",
    "constant_Cp": "ConstantSpecificHeat",
    "green_naghdi": "HypoelasticPlastic",
}
"""Types that a card may write for what it gets without the block, and the law that explains them."""


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
            parts.append(_heading(slot) + "\n" + aligned([[a, b.ljust(width)] for a, b in rows]))
    return "\n\n".join(parts)


def _heading(slot: SlotSchema) -> str:
    default = f"  (left out: {slot.absent})" if slot.absent else ""
    return f"{slot.slot}  <{slot.tags[0]}>{default}"


def find_models(name: str | None = None) -> list[tuple[str, ModelSchema]]:
    """Slots and schemas of all laws, or of those that a name means: a card type or class, its initials or beginning as
    in ptw or mts, or a part of it as in drucker; SceneError naming the nearest one.
    """
    known = [(slot.slot, model) for slot, model in _models()] + list(_plain_models())
    if name is None:
        return known
    bare = {_bare(word): _bare(law) for word, law in BY_DEFAULT.items()}.get(_bare(name), _bare(name))
    for means in (_is_name, _is_short_name, _is_part):
        found = [each for each in known if means(bare, each[1])]
        if found:
            return found
    words = {_bare(word): word for _, model in known for word in _names(model)}
    near = [words[word] for word in difflib.get_close_matches(_bare(name), words, n=3, cutoff=ALIKE)]
    guess = f"did you mean {' or '.join(repr(word) for word in near)}? " if near else ""
    raise SceneError(f"no law '{name}'; {guess}`matpoint models` lists all")


def _names(model: ModelSchema) -> tuple[str, ...]:
    return (*model.types, model.law.__name__)


def _bare(name: str) -> str:
    return name.replace("_", "").replace("-", "").replace(" ", "").lower()


def _is_name(name: str, model: ModelSchema) -> bool:
    return name in map(_bare, _names(model))


def _is_short_name(name: str, model: ModelSchema) -> bool:
    initials = "".join(letter for letter in model.law.__name__ if letter.isupper()).lower()
    return name == initials or any(name == _bare(word.split("_")[0]) for word in model.types)


def _is_part(name: str, model: ModelSchema) -> bool:
    return len(name) > 2 and any(name in _bare(word) for word in _names(model))


def model_text(name: str) -> str:
    """Everything about the laws that a name means, see `find_models`; raises SceneError naming the nearest one."""
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

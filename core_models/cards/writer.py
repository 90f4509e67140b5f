"""Materials written as cards."""

import math
from collections.abc import Mapping
from pathlib import Path

from lxml import etree

from core_models.atomic import replacing
from core_models.cards.reader import parse_material
from core_models.elasticity.isotropic import IsotropicElastic
from core_models.errors import MaterialError, MatpointError
from core_models.material import Material
from core_models.melting.constant import ConstantMelting
from core_models.schema import (
    CONSTANTS,
    ELASTICITY,
    SLOTS,
    UPDATE,
    ModelSchema,
    Parameter,
    SlotSchema,
)
from core_models.specific_heat.constant import ConstantSpecificHeat

LAWS_IN_BLOCKS = tuple(slot for slot in SLOTS if slot.models and slot is not UPDATE)


def write_material(material: Material, path: str | Path) -> None:
    """Write a material as a card that reads back equal: numbers with all digits, effects stated.

    Raises
    ------
    MaterialError : a card cannot say the material (a law without a card schema, a number out of range).
    OutputError : the file cannot be written; nothing is left half-written.
    """
    element = material_element(material)
    with replacing(path) as temporary:
        temporary.write_bytes(
            etree.tostring(element, xml_declaration=True, encoding="UTF-8", pretty_print=True)
        )


def material_element(material: Material) -> etree._Element:
    """The `<material>` element of a material, proved to read back equal; errors as for `write_material`."""
    try:
        element = _element(material)
        same = parse_material(element).material == material
    except (MatpointError, ValueError) as error:
        raise MaterialError(f"{material.name!r} cannot be written as a card: {error}") from error
    if not same:
        raise MaterialError(f"{material.name!r} cannot be written as a card: no tag says all of its laws")
    return element


def _element(material: Material) -> etree._Element:
    update = UPDATE.model_of(material.update)
    card = {p.tag: _fed(material, p) for p in (*CONSTANTS, *ELASTICITY)}
    element = etree.Element("material", name=material.name)
    _add_numbers(element, CONSTANTS, card)
    block = etree.SubElement(element, UPDATE.tags[0], type=update.types[0])
    _add_numbers(block, *_stated(update, material.update, card))
    _add_numbers(block, ELASTICITY, card)
    for slot in LAWS_IN_BLOCKS:
        _add_law(element if slot.places[0] == "material" else block, slot, getattr(material, slot.slot), card)
    return element


def _fed(material: Material, parameter: Parameter) -> float | None:
    """The number that a plain tag feeds; None where the material has no such law."""
    slot, _, field = parameter.field.partition(".")
    value = getattr(material, slot)
    return getattr(value, field, None) if field else value


def _add_numbers(
    block: etree._Element, parameters: tuple[Parameter, ...], numbers: Mapping[str, float | None]
) -> None:
    for parameter in parameters:
        if numbers[parameter.tag] is not None:
            etree.SubElement(block, parameter.tag).text = _in_words(numbers[parameter.tag])


def _in_words(number: float | tuple[float, ...]) -> str:
    if isinstance(number, tuple):
        return f"[{', '.join(repr(float(part)) for part in number)}]"
    return repr(float(number))


def _add_law(
    block: etree._Element, slot: SlotSchema, law: tuple | None, card: Mapping[str, float | None]
) -> None:
    """A block that states the law, or that there is none; nothing where its absence or a plain tag says so."""
    if law is None or type(law) in (IsotropicElastic, ConstantMelting, ConstantSpecificHeat):
        if slot.plain and slot.absent != slot.plain[0]:
            etree.SubElement(block, slot.tags[0], {slot.attribute: slot.plain[0]})
        return
    model = slot.model_of(law)
    if model is None:
        raise MaterialError(f"{type(law).__name__} has no card schema for <{slot.tags[0]}>")
    _add_numbers(
        etree.SubElement(block, slot.tags[0], {slot.attribute: model.types[0]}), *_stated(model, law, card)
    )


def _stated(
    model: ModelSchema, law: tuple, card: Mapping[str, float | None]
) -> tuple[tuple[Parameter, ...], dict[str, float]]:
    """The parameters that the block must state (the card or the default, infinite, gives the others), all numbers."""
    numbers = {p.tag: getattr(law, p.field) for p in model.parameters}
    return tuple(
        p for p in model.parameters if numbers[p.tag] not in (card.get(p.fallback), math.inf)
    ), numbers

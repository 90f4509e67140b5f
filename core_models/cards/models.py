"""One law read from its block by the schema of its slot."""

from collections.abc import Mapping

from lxml import etree

from core_models.cards.blocks import check_attributes, named_children, names_of
from core_models.cards.numbers import check_inert, read_value
from core_models.cards.origins import quoted, refusal
from core_models.errors import UnsupportedError
from core_models.names import suggestion
from core_models.schema import ModelSchema, Parameter, SlotSchema

Numbers = Mapping[str, float]


def chosen_model(element: etree._Element, slot: SlotSchema) -> ModelSchema | None:
    """The model that the block's type names; None for a type that switches nothing on."""
    check_attributes(element, (slot.attribute,))
    name = element.get(slot.attribute)
    if name is None:
        raise refusal(
            element, f"<{element.tag}> has no {slot.attribute}", f"give one of {', '.join(slot.types)}"
        )
    if name in slot.plain:
        return None
    if name in slot.unavailable:
        raise refusal(
            element,
            f"{slot.attribute} {quoted(name)} of <{element.tag}> is known but not available",
            f"take one of {', '.join(slot.types)}",
            UnsupportedError,
        )
    model = slot.model_named(name)
    if model is None:
        raise refusal(
            element,
            f"unknown {slot.attribute} {quoted(name)} of <{element.tag}>",
            suggestion(name, slot.types),
        )
    return model


def read_law(element: etree._Element, slot: SlotSchema, card: Numbers) -> tuple | None:
    """The law of a block, or None where it switches nothing on; `card` holds the plain numbers around it."""
    model = chosen_model(element, slot)
    if model is None:
        named_children(element, {})
        return None
    children = named_children(element, names_of((*model.parameters, *model.inert)))
    for inert in model.inert:
        if inert.tag in children:
            check_inert(children[inert.tag], inert)
    numbers = read_numbers(element, model.parameters, children, card)
    check_ascending(element, model.ascending, numbers, children)
    law = model.law(**{parameter.field: numbers[parameter.tag] for parameter in model.parameters})
    check_fault(element, law)
    return law


def check_fault(element: etree._Element, law: tuple) -> None:
    """Refuse a law that finds fault with its own numbers."""
    fault = law.fault() if hasattr(law, "fault") else ""
    if fault:
        problem, _, remedy = fault.partition(": ")
        raise refusal(element, f"<{element.tag}> of type {element.get('type')}: {problem}", remedy)


def read_numbers(
    element: etree._Element,
    parameters: tuple[Parameter, ...],
    children: Mapping[str, etree._Element],
    card: Numbers,
) -> dict[str, float]:
    """The numbers of a block by tag: those given, then defaults and values taken from elsewhere."""
    given = {p.tag: read_value(children[p.tag], p) for p in parameters if p.tag in children}
    around = {**card, **given}
    missing = {
        p.tag: _substitute(element, p, around) for p in parameters if p.tag not in given and not p.optional
    }
    return {**given, **missing}


def check_ascending(
    element: etree._Element,
    pairs: tuple[tuple[str, str], ...],
    numbers: Numbers,
    children: Mapping[str, etree._Element],
) -> None:
    """Refuse a pair of numbers of which the first is not smaller than the second."""
    for low, high in pairs:
        if low in numbers and high in numbers and not numbers[low] < numbers[high]:
            culprit = next((children[tag] for tag in (high, low) if tag in children), element)
            raise refusal(
                culprit,
                f"{high} = {numbers[high]!r} is not above {low} = {numbers[low]!r} in <{element.tag}>",
                f"give {high} above {low}",
            )


def _substitute(element: etree._Element, parameter: Parameter, around: Numbers) -> float:
    if parameter.default is not None:
        return parameter.default
    if parameter.fallback in around:
        return around[parameter.fallback]
    wanted = f"<{parameter.tag}> ({parameter.help}, {parameter.unit})"
    if parameter.fallback:
        raise refusal(
            element,
            f"<{element.tag}> lacks {wanted}, and there is no <{parameter.fallback}> to take it from",
            f"add <{parameter.tag}> here or <{parameter.fallback}> to the card",
        )
    raise refusal(element, f"<{element.tag}> lacks {wanted}", f"add <{parameter.tag}>")

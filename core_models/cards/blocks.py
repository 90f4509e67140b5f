"""The children and attributes of one element, checked against what may stand there."""

from collections.abc import Collection, Iterable, Mapping

from lxml import etree

from core_models.cards.origins import XML_BASE, origin, quoted, refusal
from core_models.errors import UnsupportedError
from core_models.names import suggestion
from core_models.schema import SLOTS, UNAVAILABLE_TAGS, Inert, Parameter, Switch


def check_attributes(element: etree._Element, valid: Collection[str]) -> None:
    """Refuse attributes other than `valid`."""
    for attribute in element.attrib:
        if attribute != XML_BASE and attribute not in valid:
            raise refusal(
                element,
                f"<{element.tag}> has an unknown attribute {attribute}",
                suggestion(attribute, valid),
            )


def named_children(
    element: etree._Element, names: Mapping[str, str], repeatable: Collection[str] = ()
) -> dict[str, etree._Element]:
    """The children of an element by canonical name; `names` maps every tag that may stand there to it.

    Of a tag in `repeatable` the first child is returned.

    Raises
    ------
    CardError : stray text, an unknown tag, a tag given twice (also under two names).
    UnsupportedError : a tag known from other codes' decks.
    """
    found: dict[str, etree._Element] = {}
    check_text(element)
    for child in element:
        if child.tag not in names:
            raise _unknown(element, child, names)
        name = names[child.tag]
        if name in found and name not in repeatable:
            raise refusal(
                child, f"<{child.tag}> is given twice, first at {origin(found[name])}", "delete one of them"
            )
        found.setdefault(name, child)
    return found


def check_text(element: etree._Element) -> None:
    """Refuse text between the children of an element."""
    for place, text in ((element, element.text), *((child, child.tail) for child in element)):
        if text and text.strip():
            raise refusal(
                place, f"stray text {quoted(text)} in <{element.tag}>", "delete it or put it in a tag"
            )


def names_of(entries: Iterable[Parameter | Inert | Switch]) -> dict[str, str]:
    """Every tag of the entries, mapped to its canonical name."""
    names: dict[str, str] = {}
    for entry in entries:
        aliases = entry.aliases if isinstance(entry, Parameter) else ()
        names |= dict.fromkeys((entry.tag, *aliases), entry.tag)
    return names


def _unknown(element: etree._Element, child: etree._Element, names: Mapping[str, str]) -> Exception:
    if child.tag in UNAVAILABLE_TAGS:
        return refusal(
            child,
            f"<{child.tag}> is known but not available",
            f"delete it; {suggestion('', names)}",
            UnsupportedError,
        )
    remedy = "; ".join(filter(None, (_home(child.tag), suggestion(child.tag, names))))
    return refusal(child, f"unknown tag <{child.tag}> in <{element.tag}>", remedy)


def _home(tag: str) -> str:
    """Where a tag belongs that stands outside its block, as in fragments whose outer tag was lost."""
    places = [(slot, model) for slot in SLOTS for model in slot.models]
    homes = [place for place in places if tag in names_of(place[1].parameters)]
    homes += [place for place in places if tag in names_of(place[1].inert)]
    if not homes:
        return ""
    slot, model = homes[0]
    return f'it belongs into a <{slot.tags[0]} {slot.attribute}="{model.types[0]}">'

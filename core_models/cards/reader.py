"""Material cards read into Materials."""

from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

from lxml import etree

from core_models.cards.assembly import Blocks, assembled_laws
from core_models.cards.blocks import check_attributes, named_children, names_of
from core_models.cards.bodies import Cylinder, read_body
from core_models.cards.includes import load_document
from core_models.cards.models import check_ascending, chosen_model, read_numbers
from core_models.cards.numbers import check_switch
from core_models.cards.origins import origin, refusal
from core_models.errors import MaterialError
from core_models.material import Material
from core_models.schema import (
    ANISOTROPY,
    CONSTANTS,
    DEAD_MODEL_TAGS,
    DEAD_TAGS,
    ELASTICITY,
    EXPANSION_COEFFICIENT,
    HEATED_FRACTION,
    SLOTS,
    SWITCHES,
    UPDATE,
    ModelSchema,
)

MODEL_TAG = UPDATE.tags[0]
BODY_TAG = "geom_object"


class UnusedTag(NamedTuple):
    """A tag of an old deck that is accepted and does nothing."""

    tag: str
    file: str
    line: int


@dataclass(frozen=True)
class MaterialCard:
    """What a `<material>` block says: the material, the bodies made of it, the tags that do nothing."""

    material: Material
    bodies: tuple[Cylinder, ...]
    unused: tuple[UnusedTag, ...]


def read_material(
    path: str | Path, search_roots: Iterable[str | Path] = (), name: str | None = None
) -> MaterialCard:
    """Read a document whose root is `<material>`.

    Parameters
    ----------
    path : the document. search_roots : folders where includes are looked for after the including file's.
    name : the material's name; else the block's attribute `name`, else the file's stem.

    Raises
    ------
    CardError : the document cannot be read; names file, line, wrong value and remedy.
    MaterialError : the laws make no sense together. UnsupportedError : a known model that is not available.
    """
    return parse_material(load_document(path, search_roots), name)


def parse_material(element: etree._Element, name: str | None = None) -> MaterialCard:
    """Read a `<material>` element, say of a scene; parameters and errors as for `read_material`."""
    if element.tag != "material":
        raise refusal(element, f"the root is <{element.tag}>", "a material document has the root <material>")
    check_attributes(element, ("name",))
    blocks = _blocks(element)
    children = [*blocks.outer.items(), *blocks.inner.items()]
    unused = tuple(
        UnusedTag(tag, *origin(child)) for tag, child in children if tag in (*DEAD_TAGS, *DEAD_MODEL_TAGS)
    )
    return MaterialCard(
        material=_material(blocks, name or element.get("name") or Path(origin(element).file).stem),
        bodies=tuple(read_body(body) for body in element.findall(BODY_TAG)),
        unused=unused,
    )


def _blocks(element: etree._Element) -> Blocks:
    outer = named_children(element, _outer_names(), repeatable=(BODY_TAG,))
    if MODEL_TAG not in outer:
        raise refusal(
            element, f"<material> lacks <{MODEL_TAG}>", f"add one of type {', '.join(UPDATE.types)}"
        )
    model = outer.pop(MODEL_TAG)
    inner = named_children(model, _inner_names(chosen_model(model, UPDATE)))
    for tag in outer.keys() & inner.keys():
        raise refusal(
            outer[tag],
            f"<{outer[tag].tag}> is given twice, first at {origin(inner[tag])}",
            "delete one of them",
        )
    return Blocks(element, model, outer, inner)


def _outer_names() -> dict[str, str]:
    """Every tag that may stand in `<material>`, mapped to its canonical name."""
    return names_of(CONSTANTS) | {tag: tag for tag in (*DEAD_TAGS, BODY_TAG)} | _slot_names("material")


def _inner_names(update: ModelSchema) -> dict[str, str]:
    """Every tag that may stand in the block of an update, mapped to its canonical name."""
    numbers = (*ELASTICITY, *update.parameters, HEATED_FRACTION, EXPANSION_COEFFICIENT, *SWITCHES)
    return names_of(numbers) | {tag: tag for tag in DEAD_MODEL_TAGS} | _slot_names(MODEL_TAG)


def _slot_names(place: str) -> dict[str, str]:
    return {tag: slot.tags[0] for slot in SLOTS if place in slot.places for tag in slot.tags}


def _origins(blocks: Blocks) -> dict[str, str]:
    """File and line of the block of each slot that has one."""
    found = {"update": str(origin(blocks.model))}
    for slot in SLOTS:
        block = blocks.outer.get(slot.tags[0], blocks.inner.get(slot.tags[0]))
        if block is not None:
            found[slot.slot] = str(origin(block))
    return found


def _material(blocks: Blocks, name: str) -> Material:
    update = chosen_model(blocks.model, UPDATE)
    constants = read_numbers(blocks.element, CONSTANTS, blocks.outer, {})
    check_ascending(blocks.element, (("room_temp", "melt_temp"),), constants, blocks.outer)
    for switch in SWITCHES:
        if switch.tag in blocks.inner:
            check_switch(blocks.inner[switch.tag], switch)
    settings = read_numbers(blocks.model, update.parameters, blocks.inner, {})
    moduli = _moduli(blocks)
    laws = assembled_laws(blocks, update.law(**settings), constants | moduli)
    try:
        return Material(name=name, **laws, origins=_origins(blocks))
    except (ArithmeticError, ValueError) as error:
        raise refusal(
            blocks.model,
            f"the laws of {name} cannot be evaluated at room temperature ({error})",
            "correct the numbers of the flow law or room_temp",
            MaterialError,
        ) from error


def _moduli(blocks: Blocks) -> dict[str, float]:
    """The two moduli of isotropic elasticity; none where a block states another one."""
    tag = ANISOTROPY.tags[0]
    if tag not in blocks.inner:
        return read_numbers(blocks.model, ELASTICITY, blocks.inner, {})
    for parameter in ELASTICITY:
        if parameter.tag in blocks.inner:
            raise refusal(
                blocks.inner[parameter.tag],
                f"<{parameter.tag}> stands beside an <{tag}>",
                "delete one of them",
            )
    return {}

"""Try to read every card file of a folder: what each holds, or why it is refused.

    python setup/read_cards.py FOLDER

Documents with materials are read as such; files that are made to be included, block by block, with copper's constants
for those that a block takes from the card around it.
"""

import logging
import sys
from collections import Counter
from collections.abc import Callable, Iterator
from pathlib import Path

from lxml import etree

from core_models.cards import load_document, named_children, parse_material
from core_models.cards.blocks import names_of
from core_models.cards.models import read_law, read_numbers
from core_models.conduction import LEAST_OF_METALS
from core_models.errors import MatpointError
from core_models.schema import CONSTANTS, ELASTICITY, SLOTS

AROUND = {
    "density": 8930.0,
    "specific_heat": 383.0,
    "room_temp": 294.0,
    "melt_temp": 1356.0,
    "bulk_modulus": 136.35e9,
    "shear_modulus": 45.45e9,
}


def holdings(path: Path) -> Iterator[Callable[[], str]]:
    """What a file holds: a call for each material or block, which says what it is or raises the reader's error."""
    root = load_document(path)
    materials = list(root.iter("material"))
    if root.find("constitutive_model") is not None:
        root.tag = "material"
        materials = [root]
    for material in materials:
        yield lambda material=material: f"material {parse_material(material).material.name}"
    if not materials:
        for child in root:
            yield lambda child=child: fragment(child, root)


def fragment(child: etree._Element, root: etree._Element) -> str:
    """The law or the number that a child of an included file says."""
    for slot in SLOTS:
        if child.tag in slot.tags:
            law = read_law(child, slot, AROUND)
            return f"{slot.slot} {type(law).__name__ if law else child.get(slot.attribute)}"
    plain = (*CONSTANTS, *ELASTICITY)
    named_children(root, names_of(plain))
    read_numbers(root, tuple(p for p in plain if p.tag == child.tag), {child.tag: child}, {})
    remark = ""
    if child.tag == "thermal_conductivity" and float(child.text) < LEAST_OF_METALS:
        remark = f": {float(child.text):g} W/(m K), less than that of any metal"
    return f"<{child.tag}>{remark}"


def told(path: Path) -> Iterator[str]:
    """One line for each thing in a file."""
    try:
        found = list(holdings(path))
    except MatpointError as reason:
        yield f"refused: {reason}"
        return
    for holding in found:
        try:
            yield holding()
        except MatpointError as reason:
            yield f"refused: {reason}"


def main(folder: Path) -> None:
    """Print what every file holds, and how much was read and refused."""
    logging.disable(logging.INFO)
    counts: Counter[str] = Counter()
    for path in sorted(path for path in folder.rglob("*") if path.suffix in (".xml", ".ups")):
        for line in told(path):
            counts["refused" if line.startswith("refused") else "read"] += 1
            sys.stdout.write(f"{path.relative_to(folder)}: {line}\n")
    sys.stdout.write(f"{counts['read']} read, {counts['refused']} refused\n")


if __name__ == "__main__":
    main(Path(sys.argv[1]))

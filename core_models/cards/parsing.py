"""One XML file read safely: no DTD, no entities, no network, limited size."""

from pathlib import Path

from lxml import etree

from core_models.cards.origins import XML_BASE, printable
from core_models.errors import CardError

LARGEST_FILE = 1024 * 1024  # bytes


def parse_file(path: Path) -> etree._Element:
    """Root element of an XML file, without comments and processing instructions, marked with the file's name.

    Raises
    ------
    CardError : the file is missing, too large, no well-formed XML, or has a DOCTYPE.
    """
    name = printable(path)
    try:
        root = etree.fromstring(_content(path), _parser())
    except etree.XMLSyntaxError as error:
        reason = " ".join((error.msg or "no XML").split())
        raise CardError(
            f"{name}:{error.lineno or 1}: no well-formed XML ({reason}); correct this line"
        ) from error
    if root.getroottree().docinfo.internalDTD is not None:
        raise CardError(
            f"{name}:1: DOCTYPE and entities are refused; delete the DOCTYPE and write the values out"
        )
    for element in root.iter():
        if XML_BASE in element.attrib:
            raise CardError(f"{name}:{element.sourceline}: the attribute xml:base is refused; delete it")
    root.set(XML_BASE, name)
    return root


def _content(path: Path) -> bytes:
    name = printable(path)
    try:
        if not path.is_file():
            raise CardError(f"{name}: no such file; check the path")
        with path.open("rb") as stream:
            content = stream.read(LARGEST_FILE + 1)
    except (OSError, ValueError) as error:
        raise CardError(f"{name}: cannot be read ({error}); check the path and its permissions") from error
    if len(content) > LARGEST_FILE:
        raise CardError(f"{name}:1: larger than {LARGEST_FILE} bytes; split it or delete what is no card")
    return content


def _parser() -> etree.XMLParser:
    return etree.XMLParser(
        resolve_entities=False,
        load_dtd=False,
        no_network=True,
        huge_tree=False,
        remove_comments=True,
        remove_pis=True,
    )

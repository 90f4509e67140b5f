"""Where an element of a document was written, and errors that say so."""

from pathlib import Path
from typing import NamedTuple

from lxml import etree

from core_models.errors import CardError, MatpointError

XML_BASE = "{http://www.w3.org/XML/1998/namespace}base"
LONGEST_QUOTE = 60


class Origin(NamedTuple):
    """File and line of an element."""

    file: str
    line: int

    def __str__(self) -> str:
        return f"{self.file}:{self.line}"


def origin(element: etree._Element) -> Origin:
    """File and line where the element was written, also after it was spliced into another document."""
    bases = (node.get(XML_BASE) for node in (element, *element.iterancestors()))
    return Origin(next(filter(None, bases), "<memory>"), element.sourceline or 1)


def refusal(
    element: etree._Element, problem: str, remedy: str, kind: type[MatpointError] = CardError
) -> MatpointError:
    """The error that names the element's file and line, the problem and the remedy."""
    return kind(f"{origin(element)}: {problem}; {remedy}")


def quoted(text: str | None) -> str:
    """Text of a document as it may stand in a one-line message."""
    shown = repr((text or "").strip())
    return shown if len(shown) <= LONGEST_QUOTE else shown[:LONGEST_QUOTE] + "…'"


def printable(path: Path) -> str:
    """A path as it may stand in a message and in XML."""
    return "".join(c if c.isprintable() else "?" for c in str(path))

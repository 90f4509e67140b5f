"""A look at the head of an XML file before a permissive parser gets it."""

from pathlib import Path
from xml.parsers import expat

from core_models.errors import MeshError


class _FirstElement(Exception):
    """Ends the parse: the prolog is over and nothing forbidden was in it."""


def refuse_document_type(path: Path) -> None:
    """Raise MeshError when an XML file begins with a DOCTYPE (which could define entities) or is not XML."""
    parser = expat.ParserCreate()

    def refuse(*_: object) -> None:
        raise MeshError(
            f"{path}:{parser.CurrentLineNumber}: DOCTYPE is not allowed in a mesh file; remove it"
        )

    def stop(*_: object) -> None:
        raise _FirstElement

    parser.StartDoctypeDeclHandler = refuse
    parser.StartElementHandler = stop
    try:
        with path.open("rb") as file:
            parser.ParseFile(file)
    except _FirstElement:
        return
    except expat.ExpatError as error:
        raise MeshError(f"{path}: is not an XML file ({error}); write it again") from None

"""Documents with their includes spliced in place."""

from collections.abc import Iterable
from pathlib import Path

from lxml import etree

from core_models.cards.blocks import check_attributes
from core_models.cards.origins import XML_BASE, origin, printable, quoted, refusal
from core_models.cards.parsing import LARGEST_FILE, parse_file
from core_models.cards.shipped import DATA_FOLDER
from core_models.errors import UnsupportedError

INCLUDE_ROOT = "Uintah_Include"

DEEPEST_INCLUDE = 32
MOST_INCLUDES = 512


def load_document(path: str | Path, search_roots: Iterable[str | Path] = ()) -> etree._Element:
    """Root element of a document, each `<include href="..."/>` replaced by the children of its file.

    An href is tried relative to the including file, then in each of `search_roots`, then in the shipped data.
    `origin(element)` tells the file and line of every element.

    Raises
    ------
    CardError : a file is missing, malformed or too large, includes are cyclic, a root is not Uintah_Include.
    """
    roots = (*map(Path, search_roots), DATA_FOLDER)
    return _Splicer(roots).load(Path(path), ())


class _Splicer:
    """Loads one document; counts and sizes add up, so that includes cannot multiply it."""

    def __init__(self, search_roots: tuple[Path, ...]) -> None:
        self._search_roots = search_roots
        self._size = 0
        self._includes = 0

    def load(self, path: Path, chain: tuple[Path, ...]) -> etree._Element:
        root = parse_file(path)
        self._size += path.stat().st_size
        for include in list(root.iter("include")):
            self._splice(include, path, (*chain, path))
        return root

    def _splice(self, include: etree._Element, path: Path, chain: tuple[Path, ...]) -> None:
        target = self._find(include, path)
        self._refuse_endless(include, target, chain)
        included = self.load(target, chain)
        if included.tag != INCLUDE_ROOT:
            raise refusal(
                included, f"an included file has the root <{included.tag}>", f"make it <{INCLUDE_ROOT}>"
            )
        for owner, text in ((include, include.text), (include, include.tail), (included, included.text)):
            if text and text.strip():
                raise refusal(owner, f"stray text {quoted(text)}", "delete it")
        parent = include.getparent()
        place = parent.index(include)
        parent.remove(include)
        for child in reversed(list(included)):
            child.set(XML_BASE, origin(child).file)
            parent.insert(place, child)

    def _find(self, include: etree._Element, path: Path) -> Path:
        if include.getparent() is None:
            raise refusal(include, "a document cannot be an <include> itself", "put it into a root element")
        if include.get("section") is not None:
            raise refusal(
                include,
                "an include of one section is not available",
                "put the section into a file of its own and include that",
                UnsupportedError,
            )
        check_attributes(include, ("href",))
        if len(include):
            raise refusal(include, f"<include> holds <{include[0].tag}>", "move it out of the include")
        href = (include.get("href") or "").strip()
        if not href:
            raise refusal(include, "<include> names no file", 'write <include href="file.xml"/>')
        folders = (path.parent, *self._search_roots)
        for folder in folders:
            if _is_file(folder / href):
                return folder / href
        tried = ", ".join(printable(folder) for folder in folders)
        raise refusal(
            include,
            f"included file {quoted(href)} not found in {tried}",
            "correct the href or add a search root",
        )

    def _refuse_endless(self, include: etree._Element, target: Path, chain: tuple[Path, ...]) -> None:
        if target.resolve() in [file.resolve() for file in chain]:
            names = " -> ".join(printable(file) for file in (*chain, target))
            raise refusal(include, f"the includes form a cycle: {names}", "remove one of them")
        self._includes += 1
        if len(chain) > DEEPEST_INCLUDE or self._includes > MOST_INCLUDES or self._size > LARGEST_FILE:
            raise refusal(
                include,
                f"more than {MOST_INCLUDES} includes, {DEEPEST_INCLUDE} in a chain or {LARGEST_FILE} bytes in all",
                "include less",
            )


def _is_file(path: Path) -> bool:
    try:
        return path.is_file()
    except (OSError, ValueError):
        return False

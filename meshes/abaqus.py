"""Abaqus input files (.inp): nodes, elements, sets and surfaces, read.

Read here and not by meshio, which knows neither surfaces nor axisymmetric and plane strain elements.
"""

import re
from collections.abc import Callable
from pathlib import Path

import numpy as np

from core_models.errors import MeshError
from core_models.names import suggestion
from meshes.abaqus_text import Card, cards, element_type, name_of, number_of, range_of, rows_of
from meshes.kinds import FACET_NODES, KINDS
from meshes.parsed import Block, Named, Parsed

FACES = {"tri": (0, 1, 2), "quad": (0, 1, 2, 3), "tet": (3, 0, 1, 2), "hex": (4, 5, 2, 1, 3, 0)}
"""Local facet numbers of the faces S1, S2, ..."""

ORDERS = {"line3": (0, 2, 1), "hex27": (*range(20), 26, 24, 23, 25, 21, 22, 20)}
"""Places in Abaqus's elements of the nodes in VTK's order, where these differ."""

_MAKERS = ("INCLUDE", "NGEN", "NFILL", "NCOPY", "NMAP", "ELGEN", "ELCOPY", "SYSTEM")
"""Keywords that make or move nodes or elements, which cannot be skipped."""


def read_abaqus(path: Path) -> Parsed:
    """The nodes, elements, node sets, element sets and surfaces of one part; other keywords are skipped.

    Raises MeshError with file and line: several parts, generated or included nodes, numbers that are none, nodes,
    elements and sets that are used but not given, and elements of a type that is not known.
    """
    reader = _Reader(path)
    parts = 0
    for card in cards(path):
        parts += card.keyword == "PART"
        if parts > 1:
            raise MeshError(f"{path}:{card.line}: holds more than one part; export one body in one part")
        if card.keyword in _MAKERS:
            raise MeshError(
                f"{path}:{card.line}: *{card.keyword} is not read; write out all nodes and elements"
            )
        try:
            reader.take(card)
        except (ValueError, IndexError) as error:
            raise MeshError(
                f"{path}:{card.line}: *{card.keyword} cannot be read ({error}); export the file again"
            ) from None
    return reader.parsed()


class _Reader:
    """Collects cards; sets are known by their names in upper case, as Abaqus takes them."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._coordinates: list[np.ndarray] = []
        self._node_number: dict[int, int] = {}
        self._blocks: list[Block] = []
        self._element_place: dict[int, tuple[int, int]] = {}
        self._spelling: dict[str, str] = {}
        self._node_sets: dict[str, list[int]] = {}
        self._element_sets: dict[str, list[int]] = {}
        self._faces: dict[str, list[tuple[int, int, int]]] = {}

    def take(self, card: Card) -> None:
        """Read one keyword, if it is of the mesh."""
        known: dict[str, Callable[[Card], None]] = {
            "NODE": self._nodes,
            "ELEMENT": self._elements,
            "NSET": self._node_set,
            "ELSET": self._element_set,
            "SURFACE": self._surface,
        }
        if card.keyword in known:
            known[card.keyword](card)

    def parsed(self) -> Parsed:
        """All that was read."""
        if not self._coordinates:
            raise MeshError(
                f"{self._path}: truncated or not an .inp file: it holds no nodes; export it again"
            )
        named = {name: self._named(key) for key, name in self._spelling.items()}
        return Parsed(np.array(self._coordinates), self._blocks, named)

    def _nodes(self, card: Card) -> None:
        if card.parameters.get("SYSTEM", "R").upper() != "R":
            raise ValueError("coordinates that are not rectangular")
        for entries in card.data:
            number, values = int(entries[0]), [number_of(entry) for entry in entries[1:4]]
            if len(values) < 2:
                raise ValueError(f"node {number} has {len(values)} coordinates")
            place = np.array([*values, 0.0][:3])
            if number in self._node_number:
                raise ValueError(f"node {number} is given twice")
            self._node_number[number] = len(self._coordinates)
            self._coordinates.append(place)
            self._add(self._node_sets, card.parameters.get("NSET"), [number])

    def _elements(self, card: Card) -> None:
        kind = element_type(name_of(card, "TYPE"))
        nodes = FACET_NODES.get(kind, KINDS[kind].reference_nodes if kind in KINDS else None)
        rows = rows_of(card.data, None if nodes is None else len(nodes) + 1)
        numbers = [row[0] for row in rows]
        cells = np.array([[self._node(node) for node in row[1:]] for row in rows], dtype=np.int64)
        if kind in ORDERS and len(cells):
            cells = cells[:, ORDERS[kind]]
        for row, number in enumerate(numbers):
            if number in self._element_place:
                raise ValueError(f"element {number} is given twice")
            self._element_place[number] = (len(self._blocks), row)
        if len(cells):
            self._blocks.append(Block(kind, cells))
        self._add(self._element_sets, card.parameters.get("ELSET"), numbers)

    def _node_set(self, card: Card) -> None:
        self._add(self._node_sets, name_of(card, "NSET"), self._members(card, self._node_sets, "node set"))

    def _element_set(self, card: Card) -> None:
        self._add(
            self._element_sets, name_of(card, "ELSET"), self._members(card, self._element_sets, "element set")
        )

    def _surface(self, card: Card) -> None:
        name, kind = name_of(card, "NAME"), card.parameters.get("TYPE", "ELEMENT").upper()
        if kind == "NODE":
            whole = card._replace(data=[entries[:1] for entries in card.data])
            self._add(self._node_sets, name, self._members(whole, self._node_sets, "node set"))
            return
        if kind != "ELEMENT":
            raise ValueError(f"surface '{name}' has the type {kind}, not ELEMENT or NODE")
        faces = self._faces.setdefault(self._key(name), [])
        for entries in card.data:
            face = entries[1].upper() if len(entries) > 1 else ""
            if not re.fullmatch(r"S[1-6]", face):
                raise ValueError(f"surface '{name}' has the face '{face}', not one of S1 to S6")
            for number in self._members(card._replace(data=[entries[:1]]), self._element_sets, "element set"):
                block, row = self._place(number)
                ours = FACES.get(self._blocks[block].type.rstrip("0123456789"), ())
                if int(face[1]) > len(ours):
                    raise ValueError(f"element {number} has no face {face}")
                faces.append((block, row, ours[int(face[1]) - 1]))

    def _members(self, card: Card, sets: dict[str, list[int]], what: str) -> list[int]:
        """The numbers that a set lists, by themselves, as ranges, or as sets."""
        if "GENERATE" in card.parameters:
            ranges = ([int(entry) for entry in entries] for entries in card.data)
            return [number for limits in ranges for number in range_of(limits)]
        members = []
        for entry in (entry for entries in card.data for entry in entries if entry):
            if entry.isdecimal():
                members.append(int(entry))
            elif entry.strip('"').upper() in sets:
                members += sets[entry.strip('"').upper()]
            else:
                raise ValueError(
                    f"no {what} '{entry}'; {suggestion(entry, (self._spelling[key] for key in sets))}"
                )
        return members

    def _add(self, sets: dict[str, list[int]], name: str | None, members: list[int]) -> None:
        if name is not None:
            sets.setdefault(self._key(name), []).extend(members)

    def _key(self, name: str) -> str:
        """The name as Abaqus takes it; the spelling that came first is kept."""
        self._spelling.setdefault(name.upper(), name)
        return name.upper()

    def _node(self, number: int) -> int:
        if number not in self._node_number:
            raise ValueError(f"node {number} is used but not given")
        return self._node_number[number]

    def _place(self, number: int) -> tuple[int, int]:
        if number not in self._element_place:
            raise ValueError(f"element {number} is used but not given")
        return self._element_place[number]

    def _named(self, key: str) -> Named:
        try:
            places = [self._place(number) for number in self._element_sets.get(key, [])]
            nodes = [self._node(number) for number in self._node_sets.get(key, [])]
        except ValueError as error:
            raise MeshError(
                f"{self._path}: the set '{self._spelling[key]}' cannot be read ({error})"
            ) from None
        return Named(
            np.array(places, dtype=np.int64).reshape(-1, 2),
            np.array(self._faces.get(key, []), dtype=np.int64).reshape(-1, 3),
            np.array(nodes, dtype=np.int64),
        )

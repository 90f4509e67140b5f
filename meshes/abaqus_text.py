"""The text of Abaqus input files: keywords with their data, numbers, ranges and types of elements.

What cannot be read is a ValueError; the reader adds file and line.
"""

import re
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

LONGEST_RANGE = 10**7
"""Of node or element numbers in one set, beyond which a file is taken for damaged."""

_TYPE = re.compile(r"(CPS|CPE|CAX|DC2D|DCAX|M3D|SFM3D|R3D|STRI|S|DC3D|C3D|T2D|T3D|B2|B3)(\d+?)(?:[5A-Z]\w*)?")
_SOLID = {"4": "tet4", "8": "hex8", "10": "tet10", "20": "hex20", "27": "hex27"}
_PLANE = {"3": "tri3", "4": "quad4", "6": "tri6", "8": "quad8", "9": "quad9"}
_LINE = {"2": "line2", "3": "line3"}
_BEAM = {"1": "line2", "2": "line3", "3": "line3"}


class Card(NamedTuple):
    """A keyword with its parameters, its data lines, and its line number in the file."""

    keyword: str
    parameters: dict[str, str]
    data: list[list[str]]
    line: int


def cards(path: Path) -> Iterator[Card]:
    """The keywords of a file one by one, comments left out."""
    card = None
    with path.open(encoding="utf-8-sig", errors="replace") as file:
        for number, line in enumerate(file, 1):
            text = line.strip()
            if text.startswith("**") or not text:
                continue
            if not text.startswith("*"):
                if card is not None:
                    card.data.append([entry.strip() for entry in text.rstrip(",").split(",")])
                continue
            if card is not None:
                yield card
            keyword, *words = (word.strip() for word in text[1:].split(","))
            pairs = (word.partition("=") for word in words)
            parameters = {key.strip().upper(): value.strip().strip('"') for key, _, value in pairs}
            card = Card(" ".join(keyword.upper().split()), parameters, [], number)
    if card is not None:
        yield card


def element_type(name: str) -> str:
    """The kind of element or facet that an Abaqus type such as CAX4R is; its own name when it is none."""
    found = _TYPE.fullmatch(name.upper())
    if found is None:
        return name
    family, count = found.groups()
    table = {"C3D": _SOLID, "DC3D": _SOLID, "T2D": _LINE, "T3D": _LINE, "B2": _BEAM, "B3": _BEAM}
    return table.get(family, _PLANE).get(count, name)


def rows_of(data: list[list[str]], length: int | None) -> list[list[int]]:
    """Whole numbers in rows of so many, which may run over lines; without a length every line is a row."""
    lines = [[int(entry) for entry in entries if entry] for entries in data]
    if length is None:
        return lines
    flat = [number for line in lines for number in line]
    if len(flat) % length:
        raise ValueError(f"{len(flat)} numbers do not make elements of {length - 1} nodes")
    return [flat[start : start + length] for start in range(0, len(flat), length)]


def number_of(text: str) -> float:
    """A number as Fortran writes it; an empty place is 0."""
    return float(text.replace("D", "E").replace("d", "e") or 0.0)


def range_of(limits: list[int]) -> range:
    """The numbers from the first to the last, by the step if there is one."""
    if len(limits) not in (2, 3) or limits[1] - limits[0] > LONGEST_RANGE:
        raise ValueError(f"{limits} is no range of numbers")
    return range(limits[0], limits[1] + 1, *limits[2:])


def name_of(card: Card, key: str) -> str:
    """The value of a parameter that a keyword must have."""
    if not card.parameters.get(key):
        raise ValueError(f"it has no {key}")
    return card.parameters[key]

"""Attributes of a scene document's elements, read strictly."""

import math
import re
from pathlib import Path

from lxml import etree

from core_models.cards import refusal
from core_models.cards.numbers import NUMBER
from core_models.errors import SceneError
from core_models.names import suggestion


def number_attribute(element: etree._Element, name: str, default: float | None = None) -> float | None:
    """A finite decimal number; `default` when the attribute is left out."""
    text = element.get(name)
    if text is None:
        return default
    if not NUMBER.fullmatch(text.strip()) or not math.isfinite(float(text)):
        raise refusal(element, f'{name}="{text}" is no number', "write it like 80e-6", SceneError)
    return float(text)


def required_number(element: etree._Element, name: str) -> float:
    """A finite decimal number that must be there."""
    value = number_attribute(element, name)
    if value is None:
        raise refusal(element, f"<{element.tag}> lacks {name}", f'add {name}="..."', SceneError)
    return value


def required_text(element: etree._Element, name: str) -> str:
    """A non-empty text that must be there."""
    text = (element.get(name) or "").strip()
    if not text:
        raise refusal(element, f"<{element.tag}> lacks {name}", f'add {name}="..."', SceneError)
    return text


def choice(element: etree._Element, name: str, valid: tuple[str, ...]) -> str:
    """One of the valid words, which must be there."""
    text = required_text(element, name)
    if text not in valid:
        raise refusal(element, f'{name}="{text}" is unknown', suggestion(text, valid), SceneError)
    return text


def whole_numbers(element: etree._Element, name: str) -> tuple[int, ...]:
    """Whole numbers of at least 2, ascending, separated by blanks; empty when the attribute is left out."""
    words = element.get(name, "").split()
    if not all(re.fullmatch("[0-9]{1,9}", word) and int(word) >= 2 for word in words):
        raise refusal(
            element,
            f'{name}="{element.get(name)}" leaves no cell',
            "write whole numbers of 2 or more",
            SceneError,
        )
    return tuple(sorted({int(word) for word in words}))


def local_file(element: etree._Element, folder: Path) -> Path:
    """The file that href names, inside the scene's folder."""
    href = required_text(element, "href")
    path = (folder / href).resolve()
    if not path.is_relative_to(folder.resolve()):
        raise refusal(
            element, f'href="{href}" leads out of the scene\'s folder', "put the file beside it", SceneError
        )
    if not path.is_file():
        raise refusal(element, f'href="{href}": no such file in {folder}', "correct the name", SceneError)
    return folder / href

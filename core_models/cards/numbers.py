"""Strict numbers."""

import math
import re

from lxml import etree

from core_models.cards.blocks import check_attributes
from core_models.cards.origins import quoted, refusal
from core_models.errors import UnsupportedError
from core_models.schema import ANY_NUMBER_OF, Inert, Interval, Parameter, Switch

NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?", re.ASCII)
MISSING_EXPONENT_MARK = re.compile(r"([+-]?(?:\d+\.?\d*|\.\d+))[dD]?([+-]\d+)", re.ASCII)


def read_number(element: etree._Element) -> float:
    """The decimal number of an element; nan, inf, hexadecimal, underscores and "1.3-11" are refused."""
    return _number(element, _leaf_text(element))


def read_value(element: etree._Element, parameter: Parameter) -> float | tuple[float, ...]:
    """The number or vector of a parameter, within its range."""
    numbers = (read_number(element),) if parameter.size == 1 else _vector(element, parameter.size)
    for number in numbers:
        _check_range(element, number, parameter)
    return numbers[0] if parameter.size == 1 else numbers


def check_inert(element: etree._Element, inert: Inert) -> None:
    """Refuse a value that would switch an effect on that is not offered."""
    number = read_number(element)
    if number not in inert.range:
        raise refusal(
            element,
            f"<{element.tag}> is {number!r}, but {inert.effect} is not available",
            f"delete the tag or give {_wanted(inert.range)}",
            UnsupportedError,
        )


def check_switch(element: etree._Element, switch: Switch) -> None:
    """Refuse a word that would switch something on, or off, that is not offered."""
    word = _leaf_text(element)
    if word not in switch.words:
        raise refusal(
            element,
            f"<{element.tag}> is {quoted(word)}, but {switch.effect} is not available",
            f"delete the tag or give {' or '.join(switch.words)}",
            UnsupportedError,
        )


def _check_range(element: etree._Element, number: float, parameter: Parameter) -> None:
    if number not in parameter.range:
        raise refusal(
            element,
            f"<{element.tag}> is {number!r}{parameter.said_unit}, out of its range",
            f"give {_wanted(parameter.range)}{parameter.said_unit}",
        )
    if parameter.whole and not number.is_integer():
        raise refusal(element, f"<{element.tag}> has {number!r}", "give whole numbers")


def _wanted(interval: Interval) -> str:
    return f"{interval.low:g}" if interval.low == interval.high else f"a value {interval}"


def _leaf_text(element: etree._Element) -> str:
    check_attributes(element, ())
    if len(element):
        raise refusal(element, f"<{element.tag}> holds <{element[0].tag}>", "write a number only")
    return (element.text or "").strip()


def _vector(element: etree._Element, size: int) -> tuple[float, ...]:
    text = _leaf_text(element)
    parts = text[1:-1].split(",")
    is_long_enough = len(parts) >= 2 if size == ANY_NUMBER_OF else len(parts) == size
    if not (text.startswith("[") and text.endswith("]") and is_long_enough):
        wanted = "two or more" if size == ANY_NUMBER_OF else size
        raise refusal(
            element, f"<{element.tag}> is {quoted(text)}", f"write {wanted} numbers like [0.0, 1.0, 0.0]"
        )
    return tuple(_number(element, part.strip()) for part in parts)


def _number(element: etree._Element, text: str) -> float:
    if not NUMBER.fullmatch(text):
        broken = MISSING_EXPONENT_MARK.fullmatch(text)
        remedy = f"did you mean {broken[1]}e{broken[2]}?" if broken else "write it like 1.3e-11"
        raise refusal(element, f"<{element.tag}> is {quoted(text)}, which is no number", remedy)
    number = float(text)
    if not math.isfinite(number):
        raise refusal(
            element, f"<{element.tag}> is {quoted(text)}, which is too large", "correct the exponent"
        )
    return number

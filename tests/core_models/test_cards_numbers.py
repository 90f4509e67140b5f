"""Strict numbers."""

import pytest
from hypothesis import given
from hypothesis import strategies as st
from lxml import etree

from core_models.cards import read_number
from core_models.errors import CardError


def number(text):
    """The number that an element with this text holds."""
    element = etree.Element("A")
    element.text = text
    return read_number(element)


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("10.e6", 1e7),
        (" 1.0e7\n", 1e7),
        ("+.5", 0.5),
        ("-3.03", -3.03),
        ("2", 2.0),
        ("1E-3", 1e-3),
        ("0", 0.0),
    ],
)
def test_decimal_numbers_are_read(text, value):
    """Numbers as old decks write them."""
    assert number(text) == value


@pytest.mark.parametrize(
    "text",
    [
        *("", ".", "1.3-11", "nan", "NaN", "inf", "-inf", "Infinity", "0x10", "1_000", "1,5", "1.0d5", "1 2"),
        *("1e", "--1", "1e400", "٣", "1e5.0", "e5", "ten", "1/2"),
    ],
)
def test_anything_else_is_refused(text):
    """nan, inf, hexadecimal, underscores, foreign digits, overflow and slips of the pen are no numbers."""
    with pytest.raises(CardError, match="<memory>:1: <A> is "):
        number(text)


def test_missing_exponent_mark_is_noticed():
    """The slip of a published deck is named with its likely meaning."""
    with pytest.raises(CardError, match=r"'1\.3-11', which is no number; did you mean 1\.3e-11\?"):
        number("1.3-11")


@given(st.floats(allow_nan=False, allow_infinity=False))
def test_every_float_comes_back_from_its_repr(value):
    """Numbers lose nothing on the way out and back."""
    assert number(repr(value)) == value


@given(st.text(alphabet="0123456789.eE+-_xnaif ", max_size=12))
def test_what_is_read_is_what_python_reads(text):
    """No accepted text means another number than it seems to."""
    try:
        value = number(text)
    except CardError:
        return
    assert value == float(text)

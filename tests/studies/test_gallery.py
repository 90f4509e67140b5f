"""The gallery: in step with its generator, its pictures whole, its cheapest number true."""

import xml.etree.ElementTree as ElementTree
from pathlib import Path

import pytest

from studies.gallery.entries import ENTRIES
from studies.gallery.page import gallery_page, picture_file

DOCS = Path(__file__).resolve().parents[2] / "docs"


def test_the_page_is_what_the_generator_writes():
    """Words, commands and asserted numbers of docs/gallery.md are those of the entries; `make gallery` writes it."""
    assert (DOCS / "gallery.md").read_text(encoding="utf-8") == gallery_page(ENTRIES)


@pytest.mark.parametrize("entry", ENTRIES, ids=lambda entry: entry.name)
def test_every_picture_is_there_and_needs_nothing_else(entry):
    """A small SVG document with the colours that it names."""
    path = DOCS / picture_file(entry)
    text = path.read_text(encoding="utf-8")
    assert ElementTree.fromstring(text).tag.endswith("svg") and len(text) < 500_000
    assert "var(--" not in text or "--ink:" in text
    assert 'href="http' not in text


def test_a_number_that_is_off_does_not_hold():
    """The tolerance is that of the entry."""
    entry = ENTRIES[0]
    assert entry.holds(entry.expected + 0.9 * entry.tolerance)
    assert not entry.holds(entry.expected + 1.1 * entry.tolerance)


def test_the_number_of_the_driven_point_holds():
    """The cheapest entry, made anew."""
    pytest.importorskip("matplotlib")
    entry = next(each for each in ENTRIES if each.name == "rate-jump")
    made = entry.make()
    assert entry.holds(made.number) and made.picture.startswith("<?xml")

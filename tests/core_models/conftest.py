"""A good card, and what its broken variants raise."""

from pathlib import Path

import pytest

from core_models.cards import read_material

GOOD_CARD = Path(__file__).parent / "good_card.xml"


@pytest.fixture
def read_card(tmp_path):
    """Read the good card after some replacements in its text."""

    def read(*changes):
        text = GOOD_CARD.read_text()
        for old, new in changes:
            assert text.count(old) == 1
            text = text.replace(old, new)
        path = tmp_path / "card.xml"
        path.write_text(text)
        return read_material(path)

    return read


@pytest.fixture
def refused(read_card, tmp_path):
    """The one-line message of the error that a changed card raises at a line."""

    def message(kind, line, *changes):
        with pytest.raises(kind) as caught:
            read_card(*changes)
        assert type(caught.value) is kind
        assert str(caught.value).startswith(f"{tmp_path}/card.xml:{line}: ")
        assert "\n" not in str(caught.value)
        return str(caught.value)

    return message

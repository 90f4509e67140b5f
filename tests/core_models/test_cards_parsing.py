"""Files that are no cards: malformed, oversized, with a DOCTYPE or entities."""

import time

import pytest

from core_models.cards import load_document, read_material
from core_models.errors import CardError

ENTITIES = "".join(f'<!ENTITY e{i + 1} "{f"&e{i};" * 20}">' for i in range(12))
BOMB = f'<!DOCTYPE material [<!ENTITY e0 "ha">{ENTITIES}]>'


def refused(path):
    """The message of the error that loading a document raises."""
    with pytest.raises(CardError) as caught:
        load_document(path)
    message = str(caught.value)
    assert message.startswith(str(path))
    assert "\n" not in message
    return message


@pytest.mark.parametrize(
    "text",
    [
        f"{BOMB}<material>&e12;</material>",
        f'{BOMB}<material name="&e12;"/>',
        '<!DOCTYPE material [<!ENTITY secret SYSTEM "file:///etc/hostname">]><material>&secret;</material>',
        '<!DOCTYPE material [<!ENTITY % x SYSTEM "http://example.org/x.dtd"> %x;]><material/>',
        '<!DOCTYPE material SYSTEM "material.dtd"><material/>',
        "<!DOCTYPE material><material/>",
        "<material>&unknown;</material>",
    ],
)
def test_doctype_and_entities_are_refused_at_once(tmp_path, text):
    """DOCTYPE and entities are refused, entity bombs without being expanded."""
    path = tmp_path / "card.xml"
    path.write_text(text)
    started = time.perf_counter()
    message = refused(path)
    assert time.perf_counter() - started < 1.0
    assert ".xml:1: " in message


def test_doctype_in_a_comment_is_no_doctype(tmp_path):
    """Old decks carry a commented-out DOCTYPE."""
    path = tmp_path / "card.xml"
    path.write_text('<!-- <!DOCTYPE material SYSTEM "input.dtd"> --><material/>')
    assert load_document(path).tag == "material"


def test_file_above_one_mebibyte_is_refused(tmp_path):
    """Oversized files are refused, whatever they hold; a file at the limit is read."""
    path = tmp_path / "card.xml"
    path.write_bytes(b"<material/>".ljust(1024 * 1024))
    assert load_document(path).tag == "material"
    path.write_bytes(b"<material/>".ljust(1024 * 1024 + 1))
    assert "1048576 bytes" in refused(path)


@pytest.mark.parametrize(
    "content",
    [
        b"",
        b"<material>",
        b"<material></materia>",
        b"no XML",
        b"\x00\xff\xfe",
        b'<?xml version="1.0" encoding="no-such-encoding"?><material/>',
        b"<material>" * 400 + b"</material>" * 400,
        b'<material xml:base="/elsewhere.xml"/>',
    ],
)
def test_malformed_file_is_refused_with_its_line(tmp_path, content):
    """What is no well-formed XML is a CardError with file and line."""
    path = tmp_path / "card.xml"
    path.write_bytes(content)
    assert ".xml:1: " in refused(path)


def test_line_of_malformed_xml_is_named(tmp_path):
    """The line is that of the fault."""
    path = tmp_path / "card.xml"
    path.write_text("<material>\n<density>1</densty>\n</material>")
    assert f"{path}:2: " in refused(path)


def test_declared_encoding_is_honoured(tmp_path):
    """ISO-8859-1 declarations occur in the founding cards."""
    path = tmp_path / "card.xml"
    path.write_bytes(
        "<?xml version='1.0' encoding='ISO-8859-1' ?>\n<material name='Grün'/>".encode("latin-1")
    )
    assert load_document(path).get("name") == "Grün"


@pytest.mark.parametrize("name", ["missing.xml", "", "a\0b.xml"])
def test_what_is_no_file_is_refused(tmp_path, name):
    """A missing file, a folder and an impossible path are CardErrors."""
    with pytest.raises(CardError, match="check the path"):
        read_material(tmp_path / name)

"""Whatever a document holds, only typed errors come out."""

from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from lxml import etree

from core_models.cards import load_document, read_material, shipped_materials
from core_models.errors import MatpointError


def resolved(path):
    """The text of a card with its includes spliced in."""
    root = load_document(path)
    etree.strip_attributes(root, "{http://www.w3.org/XML/1998/namespace}base")
    return etree.tostring(root)


CARDS = [resolved(path) for path in shipped_materials().values()]
TAGS = sorted({element.tag for card in CARDS for element in etree.fromstring(card).iter()})
FRAGMENTS = [
    b"<",
    b">",
    b"</",
    b"&",
    b'"',
    b"nan",
    b"-",
    b"1e999",
    b"<include/>",
    b"<!DOCTYPE a>",
    b"\xff",
    b"\0",
]
FRAGMENTS += [
    b'<include href="inputs/MPM/MaterialData/MTSPlasticAnnCopper.xml"/>',
    b'type="none"',
    b"<m>1</m>",
]
WORDS = st.sampled_from([*TAGS, "none", "johnson_cook", "mts_model", "include", "0", "-1", "1e-5", "[0,0,0]"])
SETTINGS = settings(
    max_examples=150, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)


def survives(path):
    """Read a card; a typed one-line error that names it is no failure."""
    try:
        read_material(path)
    except MatpointError as error:
        assert str(path.parent) in str(error) or "inputs" in str(error)
        assert "\n" not in str(error)


@SETTINGS
@given(st.sampled_from(CARDS), st.data())
def test_mutilated_bytes_give_typed_errors(tmp_path, card, data):
    """Cut, overwritten and spliced bytes: a Material or a one-line typed error, nothing else."""
    for _ in range(data.draw(st.integers(1, 3))):
        at = data.draw(st.integers(0, len(card)))
        width = data.draw(st.integers(0, 30))
        card = card[:at] + data.draw(st.sampled_from(FRAGMENTS) | st.binary(max_size=3)) + card[at + width :]
    path = tmp_path / "card.xml"
    path.write_bytes(card)
    survives(path)


@SETTINGS
@given(st.sampled_from(CARDS), st.data())
def test_rearranged_elements_give_typed_errors(tmp_path, card, data):
    """Renamed, moved, dropped and refilled elements: a Material or a one-line typed error, nothing else."""
    root = etree.fromstring(card)
    for _ in range(data.draw(st.integers(1, 4))):
        element = data.draw(st.sampled_from(list(root.iter())))
        change = data.draw(st.sampled_from(["rename", "text", "type", "drop", "nest"]))
        if change == "rename":
            element.tag = data.draw(WORDS.filter(str.isidentifier))
        elif change == "text":
            element.text = data.draw(WORDS)
        elif change == "type":
            element.set("type", data.draw(WORDS))
        elif element is not root and change == "drop":
            element.getparent().remove(element)
        else:
            etree.SubElement(element, data.draw(st.sampled_from(TAGS))).text = data.draw(WORDS)
    path = tmp_path / "card.xml"
    path.write_bytes(etree.tostring(root))
    survives(path)

"""Includes: where they are looked for, and what is refused."""

import pytest

from core_models.cards import load_document, origin
from core_models.errors import CardError, UnsupportedError

LIBRARY = "<Uintah_Include>\n<density>1</density>\n</Uintah_Include>"


def write(folder, **files):
    """Write XML files into a folder."""
    folder.mkdir(parents=True, exist_ok=True)
    for name, text in files.items():
        (folder / f"{name}.xml").write_text(text)
    return folder


def including(*hrefs, root="material"):
    """A document of includes."""
    return f"<{root}>" + "\n".join(f'<include href="{href}"/>' for href in hrefs) + f"</{root}>"


def refused(path, kind=CardError, **options):
    """The message of the error that loading a document raises."""
    with pytest.raises(kind) as caught:
        load_document(path, **options)
    return str(caught.value)


def test_children_are_spliced_in_order(tmp_path):
    """The children of an included document stand where its include stood, each knowing its origin."""
    write(tmp_path, b="<Uintah_Include>\n<x/>\n<y/></Uintah_Include>")
    write(tmp_path, a='<material><first/>\n<include href="b.xml"/><last/></material>')
    root = load_document(tmp_path / "a.xml")
    assert [child.tag for child in root] == ["first", "x", "y", "last"]
    assert [str(origin(child)) for child in root] == [
        f"{tmp_path}/a.xml:1",
        f"{tmp_path}/b.xml:2",
        f"{tmp_path}/b.xml:3",
        f"{tmp_path}/a.xml:2",
    ]


def test_includes_nest(tmp_path):
    """An included document may include others, relative to itself."""
    write(tmp_path / "sub", b=including("c.xml", root="Uintah_Include"), c=LIBRARY)
    write(tmp_path, a=including("sub/b.xml"))
    (density,) = load_document(tmp_path / "a.xml")
    assert str(origin(density)) == f"{tmp_path}/sub/c.xml:2"


def test_including_file_comes_before_search_roots_and_shipped_data_last(tmp_path):
    """An href is tried relative to the including file, then in the search roots, then in the shipped data."""
    root = write(tmp_path / "root", b=LIBRARY, c=LIBRARY)
    here = write(tmp_path / "here", b=LIBRARY)
    write(here, a=including("b.xml", "c.xml", "inputs/MPM/MaterialData/IsotropicElasticAnnCopper.xml"))
    document = load_document(here / "a.xml", [root])
    assert [child.tag for child in document] == ["density", "density", "shear_modulus", "bulk_modulus"]
    assert [origin(child).file for child in document[:2]] == [f"{here}/b.xml", f"{root}/c.xml"]


def test_one_file_may_be_included_twice(tmp_path):
    """Only a cycle is refused, not a second use."""
    write(tmp_path, a=including("b.xml", "b.xml"), b=LIBRARY)
    assert len(load_document(tmp_path / "a.xml")) == 2


def test_cycle_is_refused_with_the_chain(tmp_path):
    """Cyclic includes are refused, the chain named."""
    write(tmp_path, a=including("b.xml"))
    write(tmp_path, b=including("c.xml", root="Uintah_Include"))
    back = f'<include href="../{tmp_path.name}/b.xml"/>'
    write(tmp_path, c=f"<Uintah_Include>\n\n{back}</Uintah_Include>")
    message = refused(tmp_path / "a.xml")
    assert message.startswith(f"{tmp_path}/c.xml:3: the includes form a cycle: ")
    assert message.index("a.xml -> ") < message.index("b.xml -> ") < message.index("c.xml -> ")


def test_missing_include_names_the_folders_tried(tmp_path):
    """A missing include names file, line, the href and where it was looked for."""
    write(tmp_path, a='<material>\n<include href="nowhere.xml"/></material>')
    message = refused(tmp_path / "a.xml", search_roots=[tmp_path / "roots"])
    assert message.startswith(f"{tmp_path}/a.xml:2: included file 'nowhere.xml' not found in {tmp_path}, ")
    assert f"{tmp_path}/roots" in message
    assert "search root" in message


@pytest.mark.parametrize(
    ("include", "said"),
    [
        ("<include/>", "names no file"),
        ('<include href=" "/>', "names no file"),
        ('<include hrf="b.xml"/>', "did you mean 'href'?"),
        ('<include href="a\tb.xml"/>', "not found"),
        ('<include href="http://example.org/b.xml"/>', "not found"),
        ('<include href="b.xml"/>text', "stray text 'text'"),
        ('<include href="b.xml">text</include>', "stray text 'text'"),
        ('<include href="b.xml"><x/></include>', "holds <x>"),
        ('<include href="wrong.xml"/>', "make it <Uintah_Include>"),
        ('<include href="stray.xml"/>', "stray text 'words'"),
        ('<include href="empty.xml"/>', "no well-formed XML"),
        ('<include href="."/>', "not found"),
    ],
)
def test_bad_include_is_refused(tmp_path, include, said):
    """Every bad include is a CardError that names file and line."""
    write(tmp_path, b=LIBRARY, wrong="<material/>", stray="<Uintah_Include>words</Uintah_Include>", empty="")
    write(tmp_path, a=f"<material>{include}</material>")
    message = refused(tmp_path / "a.xml")
    assert said in message
    assert ".xml:1: " in message
    assert "\n" not in message


def test_include_of_a_section_is_known_but_not_available(tmp_path):
    """What is not there yet is a typed error that says so."""
    write(tmp_path, a='<material><include href="b.xml" section="A/B"/></material>', b=LIBRARY)
    assert "file of its own" in refused(tmp_path / "a.xml", UnsupportedError)


def test_document_that_is_an_include_is_refused(tmp_path):
    """A document has a root to splice into."""
    write(tmp_path, a='<include href="b.xml"/>', b=LIBRARY)
    assert "root element" in refused(tmp_path / "a.xml")


def test_includes_cannot_multiply(tmp_path):
    """Files that include each other's copies many times over are refused instead of filling the memory."""
    for level in range(9):
        write(tmp_path, **{f"f{level}": including(*[f"f{level + 1}.xml"] * 40, root="Uintah_Include")})
    write(tmp_path, f9=LIBRARY)
    assert "include less" in refused(tmp_path / "f0.xml")


def test_deep_chain_is_refused(tmp_path):
    """A chain of includes of any length ends in a CardError."""
    for level in range(60):
        write(tmp_path, **{f"f{level}": including(f"f{level + 1}.xml", root="Uintah_Include")})
    write(tmp_path, f60=LIBRARY)
    assert "in a chain" in refused(tmp_path / "f0.xml")

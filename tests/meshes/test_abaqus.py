"""Abaqus input files as users write them."""

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from core_models.errors import MeshError
from meshes.abaqus_text import element_type
from meshes.block import block
from meshes.io import read_mesh, write_mesh

PLATE = """*Heading
 two elements
** a comment
*Part, name=plate
*Node, nset=All
  10, 0.0, 0.0
  20, 1.0, 0.0
  30, 2.0, 0.0
  40, 0.0, 1.0
  50, 1.0, 1.0
  60, 2.0, 1.0
*Element, type=CAX4R, elset=Plate
  1, 10, 20, 50, 40
  2, 20, 30, 60, 50
*End Part
"""


def mesh_of(folder, text):
    """The mesh that a text makes."""
    path = folder / "plate.inp"
    path.write_text(PLATE + text)
    return read_mesh(path)


def refusal(folder, text):
    """The one line with which a text is refused."""
    with pytest.raises(MeshError) as caught:
        mesh_of(folder, text)
    assert "\n" not in str(caught.value)
    return str(caught.value)


@pytest.mark.parametrize(
    "text",
    [
        "*Surface, type=ELEMENT, name=foot\n 1, S1\n 2, S1\n",
        "*Surface, name=foot\n PLATE, S1\n",
        "*Elset, elset=low, generate\n 1, 2, 1\n*SURFACE, NAME=foot\nLow, s1\n",
        "*Element, type=T2D2, elset=foot\n 7, 10, 20\n 8, 20, 30\n",
        "*Element, type=T2D2\n 7, 10, 20\n 8, 20, 30\n*Elset, elset=foot\n 7,\n 8\n",
        "*Nset, nset=foot\n 10, 20, 30\n",
        "*Nset, nset=foot, generate\n 10, 30, 10\n",
        "*Nset, nset=some\n 10, 20\n*Nset, nset=foot\n some, 30\n",
        "*Nset, nset=some\n 10, 20\n*Surface, type=NODE, name=foot\n some, 1.0\n 30, 1.0\n",
        '*Nset, nset="foot", instance=plate-1\n 10, 20, 30\n',
    ],
)
def test_boundaries_are_surfaces_facets_or_nodes(tmp_path, text):
    """A surface, a set of facet elements, and a set of nodes name the same boundary."""
    mesh = mesh_of(tmp_path, text)
    assert mesh.kind == "quad4" and mesh.cells.tolist() == [[0, 1, 4, 3], [1, 2, 5, 4]]
    assert mesh.boundaries["foot"].tolist() == [[0, 1], [1, 2]]


def test_set_of_all_nodes_is_the_whole_rim_and_one_without_facets_no_boundary(tmp_path):
    """A set of nodes names the facets of the rim that it holds whole; the body's elements are no boundary."""
    mesh = mesh_of(tmp_path, "*Nset, nset=corners\n 10, 30, 40, 60\n*Nset, nset=Plate\n 10, 20\n")
    assert {name: len(facets) for name, facets in mesh.boundaries.items()} == {"All": 6, "corners": 2}


@pytest.mark.parametrize(
    ("text", "told"),
    [
        (
            "*Element, type=CAX4\n 3, 10, 20, 50\n",
            "plate.inp:16: *ELEMENT cannot be read (4 numbers do not make",
        ),
        ("*Element, type=CAX4\n 3, 10, 20, 50, 99\n", "node 99 is used but not given"),
        ("*Element, type=CAX4\n 2, 10, 20, 50, 40\n", "element 2 is given twice"),
        ("*Node\n 10, 1.0, 2.0\n", "node 10 is given twice"),
        ("*Node\n 70, one, 2.0\n", "could not convert string to float: 'one'"),
        ("*Node\n 70\n", "node 70 has 0 coordinates"),
        ("*Node, system=C\n 70, 1.0, 2.0\n", "not rectangular"),
        ("*Include, input=more.inp\n", "*INCLUDE is not read; write out all nodes and elements"),
        ("*Ngen\n 10, 20, 1\n", "*NGEN is not read"),
        ("*Part, name=second\n", "more than one part"),
        ("*Surface, name=foot\n plates, S1\n", "no element set 'plates'; did you mean 'Plate'"),
        ("*Surface, name=foot\n 1, S5\n", "element 1 has no face S5"),
        ("*Surface, name=foot\n 1, SPOS\n", "the face 'SPOS', not one of S1 to S6"),
        ("*Surface, name=foot\n 9, S1\n", "element 9 is used but not given"),
        ("*Surface\n 1, S1\n", "it has no NAME"),
        ("*Nset, nset=foot\n 10, 99\n", "the set 'foot' cannot be read (node 99 is used but not given)"),
        ("*Elset, elset=foot\n 1, 99\n", "the set 'foot' cannot be read (element 99 is used but not given)"),
        ("*Element\n 3, 10, 20, 50\n", "it has no TYPE"),
        ("*Nset, nset=foot, generate\n 10\n", "[10] is no range of numbers"),
        ("*Nset, nset=foot, generate\n 10, 1000000000000\n", "is no range of numbers"),
        ("*Element, type=CAX3\n 3, 10, 20, 50\n", "holds 2 quad4 and 1 tri3 elements"),
        ("*Element, type=C3D6\n 3, 10, 20, 50, 40, 30, 60\n", "holds cells of type C3D6"),
    ],
)
def test_what_cannot_be_read_is_named(tmp_path, text, told):
    """File, line, keyword and cause of what cannot be read are in one line."""
    assert told in refusal(tmp_path, text)


@pytest.mark.parametrize(
    ("name", "kind"),
    [
        ("CPS4R", "quad4"),
        ("cpe8rh", "quad8"),
        ("CAX4P", "quad4"),
        ("CAX3", "tri3"),
        ("CPE6M", "tri6"),
        ("S4R5", "quad4"),
        ("S8R5", "quad8"),
        ("STRI3", "tri3"),
        ("STRI65", "tri6"),
        ("M3D9", "quad9"),
        ("C3D8I", "hex8"),
        ("C3D10MH", "tet10"),
        ("C3D20RH", "hex20"),
        ("C3D27", "hex27"),
        ("DC3D4", "tet4"),
        ("T3D3", "line3"),
        ("B31", "line2"),
        ("B32", "line3"),
        ("C3D15", "C3D15"),
        ("CPEG4", "CPEG4"),
    ],
)
def test_types_of_elements_are_known_by_their_nodes(name, kind):
    """Families and variants of Abaqus's elements are the kinds with as many nodes."""
    assert element_type(name) == kind


@settings(max_examples=15, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(keep=st.floats(0.0, 1.0))
def test_truncated_file_is_the_mesh_or_an_error(tmp_path, keep):
    """A file cut anywhere gives a mesh or a MeshError, never another exception."""
    write_mesh(tmp_path / "whole.inp", block([0, 0, 0], [1, 1, 1], [2, 1, 1], "hex20"))
    content = (tmp_path / "whole.inp").read_bytes()
    (tmp_path / "cut.inp").write_bytes(content[: int(keep * len(content))])
    try:
        mesh = read_mesh(tmp_path / "cut.inp")
    except MeshError as error:
        assert "cut.inp" in str(error)
    else:
        assert np.isfinite(mesh.points).all()

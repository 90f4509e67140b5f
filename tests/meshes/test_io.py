"""Mesh files in and out."""

import os
import warnings
from dataclasses import replace
from pathlib import Path

import meshio
import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from core_models.errors import MeshError, OutputError
from meshes.axisymmetric import BAR
from meshes.block import block
from meshes.boundaries import require_boundaries
from meshes.io import read_mesh, write_domains_vtu, write_mesh, write_pvd
from meshes.join import join
from meshes.kinds import KINDS
from meshes.mesh import Mesh
from meshes.shape_functions import shape_values
from meshes.taylor_bar import taylor_bar


@pytest.fixture(scope="module")
def bar():
    """A graded bar of 12 elements."""
    return taylor_bar(3.2e-3, 32.4e-3, 2, 6, grading=2.0, foot_height=1e-3)


def write_with_gmsh(
    path,
    version=4.1,
    binary=False,
    order=1,
    recombine=True,
    names=("foot", "side", "rear", "axis"),
    incomplete=False,
    thickness=0.0,
):
    """Have gmsh itself write the mesh of a 1 m x 2 m bar, as a user would; with a thickness, in 3-D."""
    import gmsh

    gmsh.initialize([], readConfigFiles=False, interruptible=False)
    try:
        gmsh.option.setNumber("General.Terminal", 0)
        gmsh.option.setNumber("Mesh.MshFileVersion", version)
        gmsh.option.setNumber("Mesh.Binary", binary)
        gmsh.option.setNumber("Mesh.ElementOrder", order)
        gmsh.option.setNumber("Mesh.SecondOrderIncomplete", incomplete)
        points = [gmsh.model.geo.addPoint(*p, 0) for p in ((0, 0), (1, 0), (1, 2), (0, 2))]
        gmsh.model.geo.addPoint(5, 5, 0)
        lines = [gmsh.model.geo.addLine(points[i], points[(i + 1) % 4]) for i in range(4)]
        surface = gmsh.model.geo.addPlaneSurface([gmsh.model.geo.addCurveLoop(lines)])
        body, sides = (2, surface), [(1, line) for line in lines]
        if thickness:
            _, body, *sides = gmsh.model.geo.extrude([body], 0, 0, thickness, [2], recombine=recombine)
        gmsh.model.geo.synchronize()
        gmsh.model.addPhysicalGroup(body[0], [body[1]], name="copper")
        for (dimension, tag), name in zip(sides, names, strict=True):
            gmsh.model.addPhysicalGroup(dimension, [tag], name=name)
        if recombine:
            gmsh.model.mesh.setRecombine(2, surface)
        gmsh.model.mesh.setTransfiniteAutomatic([(2, surface)], recombine=recombine)
        gmsh.model.mesh.generate(body[0])
        gmsh.write(str(path))
    finally:
        gmsh.finalize()


FORMATS = [(".msh", "4.1"), (".msh", "2.2"), (".inp", "4.1"), (".vtu", "4.1")]


def assert_same(back, mesh):
    """Bitwise the same points, the same elements, the same boundaries in the same order."""
    assert (back.kind, back.points.tobytes()) == (mesh.kind, mesh.points.tobytes())
    assert np.array_equal(back.cells, mesh.cells)
    assert list(back.boundaries) == list(mesh.boundaries)
    assert all(np.array_equal(back.boundaries[name], mesh.boundaries[name]) for name in mesh.boundaries)


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize(("suffix", "version"), FORMATS)
def test_mesh_comes_back_bitwise_equal(tmp_path, kind, suffix, version):
    """What write_mesh writes, read_mesh gives back, for every kind of element and format."""
    dimension, path = KINDS[kind].dimension, tmp_path / f"block{suffix}"
    mesh = block([0.1] * dimension, [1.0 / 3.0, 2.0, 3.0][:dimension], [2] * dimension, kind, distortion=0.1)
    write_mesh(path, mesh, version)
    assert_same(read_mesh(path), mesh)
    assert os.listdir(tmp_path) == [path.name]


@pytest.mark.parametrize(("suffix", "version"), FORMATS)
def test_several_bodies_and_shared_facets_come_back_equal(tmp_path, suffix, version):
    """Bodies that touch, a facet in two boundaries, and a mesh without any boundary."""
    one, other = block([0, 0], [1, 1], [2, 2]), block([1, 0], [2, 1], [2, 2])
    both = join([one, other])
    both = replace(both, boundaries=both.boundaries | {"corner": both.boundaries["bottom"][:1]})
    for mesh in (both, replace(both, boundaries={})):
        write_mesh(tmp_path / f"two{suffix}", mesh, version)
        assert_same(read_mesh(tmp_path / f"two{suffix}"), mesh)


@pytest.mark.parametrize(("version", "binary"), [(2.2, False), (2.2, True), (4.1, False), (4.1, True)])
def test_users_gmsh_mesh_is_read(tmp_path, version, binary):
    """Files that gmsh writes itself, in both formats, as text and binary, with other groups beside ours."""
    path = tmp_path / "user.msh"
    write_with_gmsh(path, version, binary)
    mesh = read_mesh(path)
    assert mesh.points.max(axis=0).tolist() == [1.0, 2.0]
    assert mesh.points[mesh.boundaries["foot"][[0, -1], [0, 1]]].tolist() == [[0, 0], [1, 0]]


def test_written_mesh_opens_in_gmsh(bar, tmp_path):
    """gmsh finds the named groups in a file written here."""
    import gmsh

    write_mesh(tmp_path / "bar.msh", bar)
    gmsh.initialize([], readConfigFiles=False, interruptible=False)
    try:
        gmsh.option.setNumber("General.Terminal", 0)
        gmsh.open(str(tmp_path / "bar.msh"))
        groups = gmsh.model.getPhysicalGroups()
        assert [gmsh.model.getPhysicalName(*group) for group in groups] == [*bar.boundaries, "body"]
    finally:
        gmsh.finalize()


def refusal(path):
    """The one line with which a file is refused."""
    with pytest.raises(MeshError) as caught:
        read_mesh(path)
    message = str(caught.value)
    assert message.startswith(str(path)) and "\n" not in message
    return message


@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize("suffix", [".msh", ".inp"])
@pytest.mark.parametrize(
    ("recombine", "order", "incomplete", "planar", "solid"),
    [
        (True, 1, False, "quad4", "hex8"),
        (True, 2, False, "quad9", "hex27"),
        (True, 2, True, "quad8", "hex20"),
        (False, 1, False, "tri3", "tet4"),
        (False, 2, False, "tri6", "tet10"),
    ],
)
def test_every_kind_is_read_as_gmsh_writes_it(
    tmp_path, dimension, suffix, recombine, order, incomplete, planar, solid
):
    """Nodes of gmsh's own elements lie where their kind has them; groups of facets are boundaries."""
    path, kind = tmp_path / f"user{suffix}", planar if dimension == 2 else solid
    write_with_gmsh(path, 4.1, False, order, recombine, incomplete=incomplete, thickness=dimension - 2)
    mesh = read_mesh(path)
    assert mesh.kind == kind and {"foot", "side", "rear", "axis"} <= set(mesh.boundaries)
    weights = shape_values(KINDS[kind].linear, KINDS[kind].reference_nodes)
    straight = np.einsum("ab,ebk->eak", weights, mesh.corners())
    assert np.abs(mesh.points[mesh.cells] - straight).max() < 1e-9
    assert np.abs(mesh.points[mesh.boundaries["foot"], 1]).max() < 1e-9
    assert "body" not in mesh.boundaries and "copper" not in mesh.boundaries


def test_mixed_elements_are_refused(tmp_path):
    """Triangles among quads are counted and the way to one kind is named."""
    points = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [2, 0, 0]], dtype=float)
    cells = [("quad", np.array([[0, 1, 2, 3]])), ("triangle", np.array([[1, 4, 2]]))]
    meshio.vtu.write(tmp_path / "mixed.vtu", meshio.Mesh(points, cells))
    assert "holds 1 quad4 and 1 tri3 elements; mesh with one kind" in refusal(tmp_path / "mixed.vtu")


def test_unknown_elements_are_refused(tmp_path):
    """Wedges are named, with the kinds that there are."""
    points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [0, 1, 1]], dtype=float)
    meshio.vtu.write(tmp_path / "wedge.vtu", meshio.Mesh(points, [("wedge", np.arange(6)[None])]))
    assert "holds cells of type wedge; mesh with one of quad4" in refusal(tmp_path / "wedge.vtu")


def test_nodes_that_are_not_there_are_refused(tmp_path):
    """An element or facet that uses a node beyond the file's is an error, not another node."""
    mesh = block([0, 0], [1, 1], [1, 1])
    points = np.pad(mesh.points, ((0, 0), (0, 1)))
    for cells in ([("quad", mesh.cells + 1)], [("line", np.array([[0, 9]])), ("quad", mesh.cells)]):
        data = {"foot": [np.array([1]), np.array([0])]} if len(cells) == 2 else {}
        meshio.vtu.write(tmp_path / "far.vtu", meshio.Mesh(points, cells, cell_data=data))
        assert "element 0 uses a node that is not there" in refusal(tmp_path / "far.vtu")


def test_facets_of_another_kind_are_refused(tmp_path):
    """A triangle named as a facet of hexahedra is named, with the kind of facet that fits."""
    mesh = block([0, 0, 0], [1, 1, 1], [1, 1, 1], "hex8")
    cells = [("triangle", mesh.cells[:, :3]), ("hexahedron", mesh.cells)]
    data = {"foot": [np.array([1]), np.array([0])]}
    meshio.vtu.write(tmp_path / "facet.vtu", meshio.Mesh(mesh.points, cells, cell_data=data))
    assert "'foot' holds tri3 elements, but facets of hex8 elements are quad4" in refusal(
        tmp_path / "facet.vtu"
    )


def test_fields_of_results_are_no_boundaries(tmp_path):
    """Cell arrays with other values than 0 and 1, or that are 1 in the body, are fields."""
    mesh = block([0, 0], [1, 1], [1, 1])
    cells = [("line", mesh.boundaries["left"]), ("quad", mesh.cells)]
    data = {
        "left": [np.array([1]), np.array([0])],
        "stress": [np.array([2.5]), np.array([0.0])],
        "failed": [np.array([1]), np.array([1])],
    }
    meshio.vtu.write(
        tmp_path / "fields.vtu", meshio.Mesh(np.pad(mesh.points, ((0, 0), (0, 1))), cells, cell_data=data)
    )
    assert list(read_mesh(tmp_path / "fields.vtu").boundaries) == ["left"]


def test_torn_mesh_is_refused(tmp_path):
    """Nodes within a body that coincide without being merged are found, with the place and the remedy."""
    mesh = block([0, 0], [3, 1], [3, 2])
    points, cells = np.vstack([mesh.points, mesh.points[1]]), mesh.cells.copy()
    cells[1, 0] = len(points) - 1
    write_mesh(tmp_path / "torn.msh", Mesh(points, "quad4", cells, {}))
    message = refusal(tmp_path / "torn.msh")
    assert "two facets lie on each other from (1, 0) to (1, 0.5) m" in message and "Coherence" in message


def test_bodies_that_touch_are_told(tmp_path, caplog):
    """Two bodies side by side are read, with a remark where they touch."""
    write_mesh(tmp_path / "two.msh", join([block([0, 0], [1, 1], [2, 2]), block([1, 0], [2, 1], [2, 2])]))
    read_mesh(tmp_path / "two.msh")
    assert "two bodies touch" in caplog.text and "in all at 2 facets" in caplog.text


def test_overlapping_bodies_in_a_file_are_refused(tmp_path):
    """Two bodies in one place are named with the extents of the overlap and a place."""
    points = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], dtype=float)
    points = np.vstack([points, points + [0.9, 0.5, 0.0]])
    meshio.vtu.write(tmp_path / "two.vtu", meshio.Mesh(points, [("quad", np.arange(8).reshape(2, 4))]))
    message = refusal(tmp_path / "two.vtu")
    assert "bodies 0 and 1 of 2 overlap: their boxes share 0.1 x 0.5 m" in message
    assert "near (0.95, 0.75) m" in message


@pytest.mark.parametrize("name", ["", " foot", "the 'foot'", 'a"b', "a,b", "a\nb", "*foot", "a=b"])
def test_names_that_files_cannot_hold_are_refused(tmp_path, name):
    """A boundary name with quotes, commas or line breaks is refused when written, and no file appears."""
    mesh = block([0, 0], [1, 1], [1, 1])
    with pytest.raises(MeshError, match="cannot be written; use letters"):
        write_mesh(tmp_path / "named.msh", replace(mesh, boundaries={name: mesh.boundaries["left"]}))
    assert os.listdir(tmp_path) == []


def test_unknown_version_is_refused(bar, tmp_path):
    """Of .msh there are two formats."""
    with pytest.raises(MeshError, match="give '4.1' or '2.2'"):
        write_mesh(tmp_path / "bar.msh", bar, "4.0")


def test_misspelt_group_is_shown(tmp_path):
    """A missing boundary name comes with the nearest group of the file; names are case-sensitive."""
    write_with_gmsh(tmp_path / "user.msh", names=("Foot", "side", "rear", "axis"))
    with pytest.raises(MeshError, match="'foot' is missing; did you mean 'Foot'"):
        require_boundaries(read_mesh(tmp_path / "user.msh"), BAR)


def test_inverted_element_names_the_file(bar, tmp_path):
    """An inverted element in a file is named together with the file."""
    path = tmp_path / "bar.vtu"
    write_mesh(path, bar)
    raw = meshio.vtu.read(path)
    raw.points[4] = raw.points[11]
    meshio.vtu.write(path, raw)
    assert "element" in refusal(path)


def test_mesh_out_of_the_plane_is_refused(bar, tmp_path):
    """A mesh drawn in x and z is refused with the remedy."""
    path = tmp_path / "bar.vtu"
    write_mesh(path, bar)
    raw = meshio.vtu.read(path)
    meshio.vtu.write(path, meshio.Mesh(raw.points[:, [0, 2, 1]], raw.cells, cell_data=raw.cell_data))
    assert "set every third coordinate to 0" in refusal(path)


def test_file_without_a_body_is_refused(tmp_path):
    """A file that holds only lines says which group to export."""
    meshio.vtu.write(tmp_path / "line.vtu", meshio.Mesh(np.eye(3), [("line", np.array([[0, 1]]))]))
    assert "holds no elements of a body; export them too" in refusal(tmp_path / "line.vtu")


def test_wrong_paths_are_refused(tmp_path):
    """No file, a folder, and an unknown suffix with the nearest known one."""
    assert "no such file" in refusal(tmp_path / "none.msh")
    (tmp_path / "folder.msh").mkdir()
    assert "no such file" in refusal(tmp_path / "folder.msh")
    assert "unknown mesh format '.vtk'; use .vtu" in refusal(tmp_path / "bar.vtk")


@pytest.mark.parametrize("suffix", [".msh", ".vtu"])
@settings(max_examples=40, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(keep=st.floats(0.0, 0.98))
def test_truncated_file_is_refused(bar, tmp_path, suffix, keep):
    """A file cut before its last lines is a MeshError, never another exception, never half a mesh."""
    whole = tmp_path / f"whole{suffix}"
    if not whole.exists():
        write_mesh(whole, bar)
    content = whole.read_bytes()
    cut = tmp_path / f"cut{suffix}"
    cut.write_bytes(content[: int(keep * len(content))])
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        refusal(cut)


@pytest.mark.parametrize("suffix", [".msh", ".inp", ".vtu"])
def test_other_content_is_refused(tmp_path, suffix):
    """Text that is no mesh at all is refused, naming the file."""
    path = tmp_path / f"letter{suffix}"
    path.write_text("Dear reader,\n")
    refusal(path)


@pytest.mark.parametrize("encoding", ["utf-8", "utf-16"])
def test_document_type_is_refused(tmp_path, encoding):
    """An XML file with a DOCTYPE is refused before its entities could expand, in any encoding."""
    path = tmp_path / "bomb.vtu"
    text = (
        f'<?xml version="1.0" encoding="{encoding}"?>\n<!DOCTYPE a [<!ENTITY b "b">]>\n<VTKFile>&b;</VTKFile>'
    )
    path.write_bytes(text.encode(encoding))
    assert ":2: DOCTYPE is not allowed" in refusal(path)


def test_oversized_file_is_refused_unread(tmp_path):
    """A file above the limit is refused without being parsed."""
    path = tmp_path / "huge.vtu"
    with path.open("wb") as file:
        file.truncate(2**28 + 1)
    assert "larger than 256 MiB" in refusal(path)


@pytest.mark.parametrize(
    ("corners", "cell"), [((4, 2), "quad"), ((3, 2), "triangle"), ((8, 3), "hexahedron"), ((4, 3), "tetra")]
)
def test_domains_come_back_with_their_data(tmp_path, corners, cell):
    """Point domains are separate cells; scalars, vectors, tensors and booleans keep their values."""
    domains = np.random.default_rng(1).random((5, *corners))
    data = {
        "temperature": np.arange(5.0),
        "stress": np.random.default_rng(2).random((5, 6)),
        "deformation_gradient": np.random.default_rng(3).random((5, 3, 3)),
        "failed": np.arange(5) > 2,
    }
    write_domains_vtu(tmp_path / "points.vtu", domains, data)
    back = meshio.vtu.read(tmp_path / "points.vtu")
    assert np.array_equal(back.points[back.cells_dict[cell]][..., : corners[1]], domains)
    for name, values in data.items():
        assert np.array_equal(np.squeeze(back.cell_data_dict[name][cell]), values.reshape(5, -1).squeeze())


def test_domains_that_are_no_cells_are_refused(tmp_path):
    """A field with too few rows, and domains of another shape, are named, and no file appears."""
    with pytest.raises(MeshError, match="'damage' has 4 rows for 5 domains"):
        write_domains_vtu(tmp_path / "points.vtu", np.zeros((5, 4, 2)), {"damage": np.zeros(4)})
    with pytest.raises(MeshError, match=r"shape \(5, 8, 2\); give"):
        write_domains_vtu(tmp_path / "points.vtu", np.zeros((5, 8, 2)), {})
    assert os.listdir(tmp_path) == []


def test_series_names_times_exactly(tmp_path):
    """A .pvd lists every frame with its time to the last digit and a quoted name."""
    from xml.etree import ElementTree

    frames = [(0.0, "frames/0.vtu"), (1e-5 / 3.0, 'frames/"a"&b.vtu')]
    write_pvd(tmp_path / "series.pvd", frames)
    entries = ElementTree.parse(tmp_path / "series.pvd").getroot().iter("DataSet")
    assert [(float(e.get("timestep")), e.get("file")) for e in entries] == frames


def test_failed_write_keeps_the_earlier_file(bar, tmp_path, monkeypatch):
    """When writing breaks off, the earlier file stays whole and nothing else is left."""
    path = tmp_path / "bar.vtu"
    write_mesh(path, bar)
    before = path.read_bytes()

    def break_off(temporary, _):
        Path(temporary).write_text("half")
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(meshio.vtu, "write", break_off)
    with pytest.raises(OutputError, match="No space left on device"):
        write_mesh(path, bar)
    assert (path.read_bytes(), os.listdir(tmp_path)) == (before, ["bar.vtu"])


def test_missing_folder_is_an_output_error(bar, tmp_path):
    """Writing into a folder that is not there says so."""
    with pytest.raises(OutputError, match="No such file or directory"):
        write_mesh(tmp_path / "none" / "bar.msh", bar)


def test_vtk_itself_reads_what_is_written(bar, tmp_path):
    """VTK, the library behind ParaView, opens meshes, polygons and the series that lists them."""
    pyvista = pytest.importorskip("pyvista")
    write_mesh(tmp_path / "bar.vtu", bar)
    whole = pyvista.read(tmp_path / "bar.vtu")
    assert np.array_equal(whole.points[:, :2], bar.points)
    assert int(whole.cell_data["foot"].sum()) == len(bar.boundaries["foot"])
    write_domains_vtu(tmp_path / "points.vtu", bar.corners(), {"damage": np.arange(len(bar.cells))})
    write_pvd(tmp_path / "series.pvd", [(0.0, "bar.vtu"), (2e-5, "points.vtu")])
    series = pyvista.get_reader(tmp_path / "series.pvd")
    assert series.time_values == [0.0, 2e-5]
    series.set_active_time_value(2e-5)
    assert series.read()[0].n_cells == len(bar.cells)

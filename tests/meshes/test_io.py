"""Mesh files in and out."""

import os
import warnings
from pathlib import Path

import meshio
import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from core_models.errors import MeshError, OutputError
from meshes.axisymmetric import BAR
from meshes.boundaries import require_boundaries
from meshes.io import read_mesh, write_mesh, write_polygons_vtu, write_pvd
from meshes.taylor_bar import taylor_bar


@pytest.fixture(scope="module")
def bar():
    """A graded bar of 12 elements."""
    return taylor_bar(3.2e-3, 32.4e-3, 2, 6, grading=2.0, foot_height=1e-3)


def write_with_gmsh(
    path, version=4.1, binary=False, order=1, recombine=True, names=("foot", "side", "rear", "axis")
):
    """Have gmsh itself write the mesh of a 1 m x 2 m bar, as a user would."""
    import gmsh

    gmsh.initialize([], readConfigFiles=False, interruptible=False)
    try:
        gmsh.option.setNumber("General.Terminal", 0)
        gmsh.option.setNumber("Mesh.MshFileVersion", version)
        gmsh.option.setNumber("Mesh.Binary", binary)
        gmsh.option.setNumber("Mesh.ElementOrder", order)
        points = [gmsh.model.geo.addPoint(*p, 0) for p in ((0, 0), (1, 0), (1, 2), (0, 2))]
        gmsh.model.geo.addPoint(5, 5, 0)
        lines = [gmsh.model.geo.addLine(points[i], points[(i + 1) % 4]) for i in range(4)]
        surface = gmsh.model.geo.addPlaneSurface([gmsh.model.geo.addCurveLoop(lines)])
        gmsh.model.geo.synchronize()
        gmsh.model.addPhysicalGroup(2, [surface], name="copper")
        for line, name in zip(lines, names, strict=True):
            gmsh.model.addPhysicalGroup(1, [line], name=name)
        if recombine:
            gmsh.model.mesh.setRecombine(2, surface)
        gmsh.model.mesh.setTransfiniteAutomatic([(2, surface)], recombine=recombine)
        gmsh.model.mesh.generate(2)
        gmsh.write(str(path))
    finally:
        gmsh.finalize()


@pytest.mark.parametrize("suffix", [".msh", ".vtu"])
def test_mesh_comes_back_bitwise_equal(bar, tmp_path, suffix):
    """What write_mesh writes, read_mesh gives back: points bitwise, elements, boundaries with their order."""
    path = tmp_path / f"bar{suffix}"
    write_mesh(path, bar)
    back = read_mesh(path)
    assert back.points.tobytes() == bar.points.tobytes()
    assert np.array_equal(back.cells, bar.cells)
    assert list(back.boundaries) == list(bar.boundaries)
    assert all(np.array_equal(back.boundaries[name], bar.boundaries[name]) for name in bar.boundaries)
    assert os.listdir(tmp_path) == [path.name]


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


def test_triangles_are_refused(tmp_path):
    """Cells other than 4-node quads are named, with the gmsh option that makes quads."""
    write_with_gmsh(tmp_path / "user.msh", recombine=False)
    assert "cells of type triangle; mesh with 4-node quads" in refusal(tmp_path / "user.msh")


def test_second_order_quads_are_refused(tmp_path):
    """Nine-node quads are refused by name."""
    write_with_gmsh(tmp_path / "user.msh", order=2)
    assert "Mesh.ElementOrder = 1" in refusal(tmp_path / "user.msh")


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


def test_file_without_quads_is_refused(tmp_path):
    """A file that holds only lines says which group to export."""
    meshio.vtu.write(tmp_path / "line.vtu", meshio.Mesh(np.eye(3), [("line", np.array([[0, 1]]))]))
    assert "holds no quads" in refusal(tmp_path / "line.vtu")


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


@pytest.mark.parametrize("suffix", [".msh", ".vtu"])
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


def test_polygons_come_back_with_their_data(tmp_path):
    """Point domains are separate quads; scalars, vectors, tensors and booleans keep their values."""
    polygons = np.random.default_rng(1).random((5, 4, 2))
    data = {
        "temperature": np.arange(5.0),
        "stress": np.random.default_rng(2).random((5, 6)),
        "deformation_gradient": np.random.default_rng(3).random((5, 3, 3)),
        "failed": np.arange(5) > 2,
    }
    write_polygons_vtu(tmp_path / "points.vtu", polygons, data)
    back = meshio.vtu.read(tmp_path / "points.vtu")
    assert np.array_equal(back.points[back.cells_dict["quad"]][..., :2], polygons)
    for name, values in data.items():
        assert np.array_equal(np.squeeze(back.cell_data_dict[name]["quad"]), values.reshape(5, -1).squeeze())


def test_polygon_data_of_another_length_is_refused(tmp_path):
    """A field with too few rows is named, and no file appears."""
    with pytest.raises(MeshError, match="'damage' has 4 rows for 5 polygons"):
        write_polygons_vtu(tmp_path / "points.vtu", np.zeros((5, 4, 2)), {"damage": np.zeros(4)})
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
    write_polygons_vtu(tmp_path / "points.vtu", bar.corners(), {"damage": np.arange(len(bar.cells))})
    write_pvd(tmp_path / "series.pvd", [(0.0, "bar.vtu"), (2e-5, "points.vtu")])
    series = pyvista.get_reader(tmp_path / "series.pvd")
    assert series.time_values == [0.0, 2e-5]
    series.set_active_time_value(2e-5)
    assert series.read()[0].n_cells == len(bar.cells)

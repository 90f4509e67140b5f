"""A scene with the user's own mesh."""

from dataclasses import replace

import pytest

from core_models.errors import MeshError, SceneError
from meshes.io import write_mesh
from meshes.taylor_bar import taylor_bar
from meshes.taylor_quarter import taylor_quarter
from studies.bar.mesh import bar_mesh
from studies.methods.method import build_solver, check_run, resolutions_of
from studies.runs.running import run
from studies.scenes.reader import read_scene


def with_mesh(classic, folder, radius=3.2e-3, foot_height=0.0):
    """The classic scene with a mesh of four elements across."""
    write_mesh(folder / "bar.msh", taylor_bar(radius, 32.4e-3, 4, foot_height=foot_height))
    return replace(classic, mesh=folder / "bar.msh", resolutions={})


def test_an_own_mesh_sets_the_resolution(classic, tmp_path):
    """Both methods take the mesh's elements across by default; FEM refuses another number."""
    scene = with_mesh(classic, tmp_path)
    assert resolutions_of(scene, "fem-explicit") == resolutions_of(scene, "mpm") == (4,)
    with pytest.raises(SceneError, match="leave the resolution out"):
        check_run(scene, "fem-explicit", 8)


@pytest.mark.parametrize(
    ("change", "told"),
    [({"radius": 4e-3}, "radius"), ({"foot_height": -1e-3}, "below the wall")],
)
def test_a_mesh_that_is_not_the_bar_is_refused(classic, tmp_path, change, told):
    """Another size than the cylinder's, or a place behind the wall, is an error with a remedy."""
    with pytest.raises(MeshError, match=told):
        resolutions_of(with_mesh(classic, tmp_path, **change), "mpm")


def test_an_own_mesh_of_another_kind_needs_its_name(classic, tmp_path):
    """A mesh of triangles is the bar of the method's variant of that name, and of no other."""
    write_mesh(tmp_path / "bar.inp", taylor_bar(3.2e-3, 32.4e-3, 4, kind="tri3", structured=False))
    scene = replace(classic, mesh=tmp_path / "bar.inp", resolutions={})
    assert bar_mesh(scene, 4, "tri3").kind == "tri3"
    with pytest.raises(SceneError, match="fem-explicit:tri3"):
        bar_mesh(scene, 4)


def test_particles_in_space_are_four_along_the_edge_of_a_cell(classic):
    """A foot that spreads in two directions is still sampled in every cell; in axial symmetry two are enough."""
    spatial, planar = (build_solver(classic, method, 2, "plane", 1) for method in ("mpm:spatial", "mpm"))
    assert spatial.points.n == 8 * len(taylor_quarter(3.2e-3, 32.4e-3, 4).cells)
    assert planar.points.n == 4 * len(taylor_bar(3.2e-3, 32.4e-3, 2).cells)


def test_a_run_keeps_the_mesh_beside_its_scene(fake_solvers, classic, tmp_path):
    """The run folder's scene.xml can be run again as it is."""
    run(with_mesh(classic, tmp_path), "mpm", out=tmp_path / "out")
    assert read_scene(tmp_path / "out/scene.xml").mesh == tmp_path / "out/bar.msh"


@pytest.mark.parametrize("method", ["fem-explicit", "mpm:spatial"])
def test_a_bar_too_slender_for_any_resolution_is_told_so(classic, method):
    """No other resolution is proposed where none fits: the cylinder is the cause."""
    scene = replace(classic, bar=replace(classic.bar, radius=1e-9))
    with pytest.raises(SceneError, match="too slender, 0.0324 m long with a radius of 1e-09 m.*<cylinder>"):
        check_run(scene, method, 6)

"""The methods a scene can be run with, by name. Solvers are imported only when one is built."""

from dataclasses import dataclass

from core_models.errors import MeshError, SceneError
from studies.names import nearest
from studies.scene import Scene


@dataclass(frozen=True)
class Method:
    """How a method is called: short label for tables, what `resolution` counts, the scene attribute."""

    label: str
    unit: str
    scene_key: str


METHODS = {
    "fem-explicit": Method("FEM", "elements across R0", "fem"),
    "mpm": Method("MPM", "cells across R0", "mpm"),
}
DEFAULT_RESOLUTION = (8, 12, 16)


def find_method(name: str) -> Method:
    """The method of that name; raises SceneError naming the nearest one."""
    if name not in METHODS:
        raise SceneError(f"unknown method '{name}'; {nearest(name, METHODS)}")
    return METHODS[name]


def resolutions_of(scene: Scene, method: str) -> tuple[int, ...]:
    """The scene's own resolutions for a method, coarse to fine."""
    return scene.resolutions.get(method, DEFAULT_RESOLUTION)


def check_resolution(resolution: int) -> int:
    """A resolution that leaves at least two elements or cells across the radius; raises SceneError."""
    if resolution < 2:
        raise SceneError(f"resolution {resolution} leaves no usable cell across the radius; give 2 or more")
    return resolution


def build_mesh(scene: Scene, resolution: int):
    """The bar as quads: the user's own mesh, or the cylinder with `resolution` elements across the radius."""
    if scene.mesh is None:
        from meshes.taylor_bar import taylor_bar

        return taylor_bar(scene.bar.radius, scene.bar.length, check_resolution(resolution))
    from meshes.io import read_mesh

    mesh = read_mesh(scene.mesh)
    if mesh.points[:, 1].min() < 0.0:
        raise MeshError(f"{scene.mesh}: has points below the wall (z = 0); move the mesh up")
    return mesh


def build_solver(scene: Scene, method: str, resolution: int, wall: str, threads: int):
    """The solver for one run, at time zero."""
    find_method(method)
    check_resolution(resolution)
    mesh = build_mesh(scene, resolution)
    common = {
        "velocity": scene.bar.velocity,
        "temperature": scene.bar.temperature,
        "wall": wall,
        "viscosity": scene.viscosity,
        "threads": threads,
    }
    if method == "fem-explicit":
        import fem

        return fem.ExplicitSolver(mesh, scene.material, **common)
    import mpm

    return mpm.Solver(mesh, scene.material, cell_size=scene.bar.radius / resolution, **common)

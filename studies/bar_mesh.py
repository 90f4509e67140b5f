"""The mesh of a scene's bar: the cylinder's, or the user's own."""

from math import sqrt
from operator import index

from core_models.errors import MeshError, SceneError
from meshes.axisymmetric import axisymmetric, check_bar
from meshes.mesh import Mesh
from studies.scene import Scene

FIT = 0.01  # largest relative difference between an own mesh's size and the cylinder it stands for
MOST_POINTS = 4_000_000
BYTES_PER_POINT = 1000  # state, kinematics and output of one point, roughly


def bar_mesh(scene: Scene, resolution: int) -> Mesh:
    """The bar as quads: the user's own mesh, or the cylinder with `resolution` elements across the radius."""
    if scene.mesh is not None:
        return own_mesh(scene)
    from meshes.taylor_bar import taylor_bar

    return taylor_bar(scene.bar.radius, scene.bar.length, check_resolution(scene, resolution))


def own_mesh(scene: Scene) -> Mesh:
    """The mesh that the scene names; raises MeshError when it is not the scene's bar in front of the wall."""
    from meshes.io import read_mesh

    mesh = axisymmetric(read_mesh(scene.mesh))
    check_bar(mesh)
    low, high = mesh.points.min(axis=0), mesh.points.max(axis=0)
    if low[1] < 0.0:
        raise MeshError(f"{scene.mesh}: reaches below the wall, to z = {low[1]:g} m; move it up to z >= 0")
    for name, size, wanted in (
        ("radius", high[0], scene.bar.radius),
        ("length", high[1] - low[1], scene.bar.length),
    ):
        if abs(size - wanted) > FIT * wanted:
            raise MeshError(
                f"{scene.mesh}: its {name} is {size:g} m, the scene's cylinder's {wanted:g} m; make them agree"
            )
    return mesh


def own_resolution(scene: Scene) -> int:
    """Elements across the radius of the user's own mesh: those of its foot."""
    return len(own_mesh(scene).boundaries["foot"])


def check_resolution(scene: Scene, resolution: int) -> int:
    """A resolution of at least two elements or cells across the radius whose points fit in memory.

    Raises SceneError, before anything of that size is made.
    """
    try:
        number = index(resolution)
    except TypeError as error:
        raise SceneError(f"resolution {resolution!r} is no whole number; give one like 8") from error
    if number < 2:
        raise SceneError(f"resolution {number} leaves no usable cell across the radius; give 2 or more")
    points_of_one = 4.0 * scene.bar.length / scene.bar.radius
    largest = int(sqrt(MOST_POINTS / points_of_one))
    if number > largest:
        points = points_of_one * number**2
        raise SceneError(
            f"resolution {number} makes some {points:.2g} points, which need about "
            f"{points * BYTES_PER_POINT / 2**30:.0f} GiB of memory; give {largest} or less"
        )
    return number

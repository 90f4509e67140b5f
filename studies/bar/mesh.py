"""The mesh of a scene's bar: the cylinder's, or the user's own."""

from math import pi
from operator import index

from core_models.errors import MeshError, SceneError
from meshes.axisymmetric import axisymmetric, check_bar
from meshes.kinds import find_kind
from meshes.mesh import Mesh
from studies.scenes.scene import Scene

FIT = 0.01  # largest relative difference between an own mesh's size and the cylinder it stands for
FEWEST = 2  # elements or cells across the radius
MOST_POINTS = 4_000_000
POINTS_OF_ONE = {2: 4.0, 3: 2.0 * pi}  # points of a body as long as wide, one element across, by dimension
BYTES_PER_POINT = 1000  # state, kinematics and output of one point, roughly


def bar_mesh(scene: Scene, resolution: int, kind: str = "quad4", per_cell: int = 1) -> Mesh:
    """The user's own mesh, or the cylinder with `resolution` times `per_cell` elements across the radius.

    kind : of the elements; a 3-D kind gives a quarter of the cylinder. Raises SceneError for too many of them, or for
    another kind than that of the user's own mesh.
    """
    if scene.mesh is not None:
        mesh = own_mesh(scene)
        if mesh.kind != kind:
            raise SceneError(
                f"{scene.mesh}: consists of {mesh.kind} elements, the method's are {kind}; "
                f"name the kind behind the method (fem-explicit:{mesh.kind}), or mesh with {kind}"
            )
        return mesh
    bar = scene.bar
    number = per_cell * check_resolution(scene, resolution, find_kind(kind).dimension, per_cell)
    if find_kind(kind).dimension == 3:
        from meshes.taylor_quarter import taylor_quarter

        return taylor_quarter(bar.radius, bar.length, number, kind=kind)
    from meshes.taylor_bar import taylor_bar

    return taylor_bar(bar.radius, bar.length, number, kind=kind)


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


def check_resolution(scene: Scene, resolution: int, dimension: int = 2, per_cell: int = 1) -> int:
    """A resolution of at least two elements or cells across the radius whose points fit in memory.

    Raises SceneError, before anything of that size is made; also for a bar so slender that no resolution fits.
    """
    try:
        number = index(resolution)
    except TypeError as error:
        raise SceneError(f"resolution {resolution!r} is no whole number; give one like 8") from error
    if number < FEWEST:
        raise SceneError(
            f"resolution {number} leaves no usable cell across the radius; give {FEWEST} or more"
        )
    points_of_one = POINTS_OF_ONE[dimension] * per_cell**dimension * scene.bar.length / scene.bar.radius
    largest = int((MOST_POINTS / points_of_one) ** (1.0 / dimension))
    if largest < FEWEST:
        raise SceneError(
            f"the bar is too slender, {scene.bar.length:g} m long with a radius of {scene.bar.radius:g} m: even "
            f"resolution {FEWEST}, the coarsest, {_needs(points_of_one * FEWEST**dimension)}; correct its <cylinder>"
        )
    if number > largest:
        raise SceneError(
            f"resolution {number} {_needs(points_of_one * number**dimension)}; give {largest} or less"
        )
    return number


def _needs(points: float) -> str:
    return f"makes some {points:.2g} points, which need about {points * BYTES_PER_POINT / 2**30:.0f} GiB of memory"

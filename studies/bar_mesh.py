"""The mesh of a scene's bar: the cylinder's, or the user's own."""

from core_models.errors import MeshError, SceneError
from meshes.quad_mesh import QuadMesh
from studies.scene import Scene

FIT = 0.01  # largest relative difference between an own mesh's size and the cylinder it stands for


def bar_mesh(scene: Scene, resolution: int) -> QuadMesh:
    """The bar as quads: the user's own mesh, or the cylinder with `resolution` elements across the radius."""
    if scene.mesh is not None:
        return own_mesh(scene)
    from meshes.taylor_bar import taylor_bar

    return taylor_bar(scene.bar.radius, scene.bar.length, check_resolution(resolution))


def own_mesh(scene: Scene) -> QuadMesh:
    """The mesh that the scene names; raises MeshError when it is not the scene's bar in front of the wall."""
    from meshes.io import read_mesh

    mesh = read_mesh(scene.mesh)
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


def check_resolution(resolution: int) -> int:
    """A resolution that leaves at least two elements or cells across the radius; raises SceneError."""
    if resolution < 2:
        raise SceneError(f"resolution {resolution} leaves no usable cell across the radius; give 2 or more")
    return resolution

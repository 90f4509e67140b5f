"""The methods a scene can be run with, by name. Solvers are imported only when one is built."""

from dataclasses import dataclass, replace

from core_models.errors import SceneError
from core_models.loads import Symmetry
from core_models.walls import Wall
from studies.bar.mesh import bar_mesh, check_resolution, own_resolution
from studies.methods.variants import read_variant
from studies.scenes.scene import Scene


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
    """The method of that name, or of a variant (`variants.py`); raises SceneError naming the nearest one."""
    method = METHODS[read_variant(name).solver]
    words = name.partition(":")[2]
    return replace(method, label=f"{method.label} {words.replace('+', ' ')}") if words else method


def resolutions_of(scene: Scene, method: str) -> tuple[int, ...]:
    """The scene's own resolutions for a method, coarse to fine; those of its own mesh if it has one."""
    find_method(method)
    if scene.mesh is not None and method not in scene.resolutions:
        return (own_resolution(scene),)
    return scene.resolutions.get(method, DEFAULT_RESOLUTION)


def check_run(scene: Scene, method: str, resolution: int) -> None:
    """Refuse, before anything is written, a method or resolution that cannot be run; raises SceneError."""
    variant = read_variant(method)
    check_resolution(scene, resolution, 3 if variant.is_spatial else 2, variant.elements_per_cell)
    if scene.mesh is not None and variant.solver == "fem-explicit" and resolution != own_resolution(scene):
        raise SceneError(
            f"{scene.mesh}: has {own_resolution(scene)} elements across the radius, not {resolution}; "
            "leave the resolution out"
        )


def planned_runs(
    scene: Scene, methods: tuple[str, ...], resolutions: tuple[int, ...] | None
) -> list[tuple[str, int]]:
    """Every method at every resolution (default: the scene's), coarse to fine, each once, all checked."""
    plan = [(method, n) for method in methods for n in resolutions or resolutions_of(scene, method)]
    for method, resolution in plan:
        check_run(scene, method, resolution)
    order = list(dict.fromkeys(methods))
    return sorted(set(plan), key=lambda job: (order.index(job[0]), job[1]))


def build_solver(scene: Scene, method: str, resolution: int, wall: str, threads: int):
    """The solver for one run, at time zero."""
    check_run(scene, method, resolution)
    variant = read_variant(method)
    mesh = bar_mesh(scene, resolution, variant.kind, variant.elements_per_cell)
    common = {
        **variant.options,
        "loads": (Symmetry("symmetry_x"), Symmetry("symmetry_y")) if variant.is_spatial else (),
        "velocity": scene.bar.velocity,
        "temperature": scene.bar.temperature,
        "wall": Wall(wall, scene.friction),
        "conduction": scene.conduction,
        "viscosity": scene.viscosity,
        "threads": threads,
    }
    if variant.solver == "fem-explicit":
        import fem

        return fem.ExplicitSolver(mesh, scene.material, **common)
    import mpm

    return mpm.Solver(mesh, scene.material, cell_size=scene.bar.radius / resolution, **common)


def check_solver(scene: Scene, method: str, resolution: int, wall: str, threads: int) -> None:
    """Refuse what building the solver would refuse, without compiling anything that only a run needs.

    Raises SceneError, MeshError or UnsupportedError.
    """
    variant = read_variant(method)
    if variant.solver != "fem-explicit":
        build_solver(scene, method, resolution, wall, threads)
        return
    from core_models.threads import Threads
    from fem.cures.choice import find_cure
    from fem.elements import FULL, find_element

    integration = variant.options.get("integration", FULL)
    find_element(variant.kind, integration)
    find_cure(variant.options.get("cure"), variant.kind, integration)
    Threads(threads)

"""Taylor bars as work-precision problems: final length and foot radius."""

from dataclasses import replace
from typing import Any

from studies.bar.outline import bar_outline
from studies.bar.shape import foot_radius, length
from studies.methods.method import build_solver
from studies.scenes.reader import read_scene
from studies.scenes.scene import End, Scene
from studies.work_precision.problem import Reference, WorkProblem

QUANTITIES = ("final_length", "foot_radius")
RESOLUTIONS = {
    "fem-explicit": (4, 6, 8, 12, 16),
    "fem-explicit:quad8": (2, 3, 4, 5, 6),  # whose steps are seven times smaller
    "mpm": (6, 8, 12, 16, 24),
    "mpm:total": (4, 5, 6, 8, 10),  # whose steps follow the squashed particles of the foot, down to a tenth
}
VARIANTS = ("fem-explicit", "fem-explicit:reduced", "fem-explicit:quad8", "mpm", "mpm:cubic", "mpm:total")
PUBLISHED = 0.0005  # relative uncertainty of a published value that is given to four digits
JOINT = Reference(None, 0.0, "joint extrapolation of all runs")
UNTIL_STANDING = {"taylor-copper-jc": 80e-6}  # s: a fixed end in place of one that depends on the rebound


def bar_problem(scene_name: str, wall: str | None = None) -> WorkProblem:
    """The problem of a shipped scene or a scene's file under a wall, by default the scene's own."""
    scene = read_scene(scene_name)
    return scene_problem(with_fixed_end(scene), wall or scene.wall)


def scene_problem(scene: Scene, wall: str) -> WorkProblem:
    """The problem of a scene that ends at a fixed time."""
    published = {
        reference.quantity: Reference(
            0.5 * (reference.low + reference.high),
            max(0.5 * (reference.high - reference.low), PUBLISHED * reference.low),
            reference.source,
        )
        for reference in scene.references
        if reference.wall == wall and not reference.source.startswith("experiment")
    }

    def build(variant: str, resolution: int, threads: int) -> Any:
        return build_solver(scene, variant, resolution, wall, threads)

    return WorkProblem(
        f"{scene.name}-{wall}",
        f"{scene.name}, wall {wall}, {scene.end.limit(wall) * 1e6:g} µs",
        {name: published.get(name, JOINT) for name in QUANTITIES},
        RESOLUTIONS,
        VARIANTS,
        build,
        lambda solver: finish_bar(solver, scene.end.limit(wall)),
        dict.fromkeys(QUANTITIES, "m"),
    )


def finish_bar(solver: Any, end: float) -> dict[str, float]:
    """Step a bar to a time [s]; its length and foot radius [m]."""
    while solver.time < end:
        solver.advance(end)
    outline = bar_outline(solver)
    return {"final_length": length(outline), "foot_radius": foot_radius(outline)}


def with_fixed_end(scene: Scene) -> Scene:
    """The scene with an end at a time that does not depend on the rebound."""
    if scene.end.time is not None:
        return scene
    return replace(scene, end=End(time=UNTIL_STANDING.get(scene.name, scene.end.limit("plane"))))

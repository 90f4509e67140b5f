"""What a scene would simulate, in words and numbers."""

from core_models.material import Material
from core_models.walls import check_wall
from studies.decisions.beforehand import decisions
from studies.decisions.text import decisions_text
from studies.methods.method import METHODS
from studies.output.display import number
from studies.output.text_table import aligned
from studies.scenes.effects import scene_effects
from studies.scenes.plan import PlannedRun, plan_of
from studies.scenes.remarks import scene_remarks
from studies.scenes.scene import Scene


def plan_text(
    scene: Scene, methods: tuple[str, ...] | None, resolutions: tuple[int, ...] | None, wall: str | None
) -> str:
    """Scene, material, effects and, per run, mesh and estimated steps; what is odd about them last."""
    wall = check_wall(wall or scene.wall)
    bar, runs = scene.bar, plan_of(scene, methods, resolutions, wall)
    parts = [
        f"{scene.name}: {scene.description}",
        f"bar      L0 {bar.length * 1e3:g} mm, R0 {bar.radius * 1e3:g} mm, "
        f"{-bar.velocity:g} m/s, {bar.temperature:g} K\n"
        f"wall     {wall}{_friction(scene)}\n"
        f"end      {_end(scene, wall)}\n"
        f"material {_laws(scene.material)}",
        "what is simulated\n" + aligned(_effect_rows(scene, wall, methods or tuple(METHODS))),
        "what the numbers ask for\n" + decisions_text(decisions(scene, wall)),
        aligned(_run_rows(runs)),
        *(f"remark: {each}" for each in scene_remarks(scene, wall, [run.first_step for run in runs])),
    ]
    if scene.unused:
        parts.append("tags that do nothing:\n" + "\n".join(f"  {tag}" for tag in scene.unused))
    return "\n\n".join(parts)


def _friction(scene: Scene) -> str:
    return f", friction {scene.friction:g}" if scene.friction else ""


def _laws(material: Material) -> str:
    return "\n         ".join(_law(law) for law in material.laws)


def _law(law: tuple) -> str:
    values = ", ".join(f"{name} {value:.6g}" for name, value in law._asdict().items())
    return f"{type(law).__name__}({values})"


def _end(scene: Scene, wall: str) -> str:
    limit = f"{scene.end.limit(wall) * 1e6:g} µs"
    if scene.end.after_release(wall):
        return f"{scene.axial_period * 1e6:.4g} µs after the bar has left the wall, at {limit} at the latest"
    return limit


def _effect_rows(scene: Scene, wall: str, methods: tuple[str, ...]) -> list[list[str]]:
    effects = scene_effects(scene, wall, methods)
    width = max(len(effect.reason) for effect in effects)
    return [[e.name, "on " if e.on else "off", e.reason.ljust(width)] for e in effects]


def _run_rows(runs: list[PlannedRun]) -> list[list[str]]:
    head = ["run", "points", "smallest edge mm", "steps to the latest end, some"]
    return [head] + [
        [
            f"{run.method} {run.resolution}",
            str(run.points),
            number(run.smallest_edge * 1e3, 3),
            f"{run.fewest_steps} to {run.most_steps}",
        ]
        for run in runs
    ]

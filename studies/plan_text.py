"""What a scene would simulate, in words and numbers."""

from math import sqrt

from core_models.laws import elastic_moduli, melting_temperature
from core_models.material import Material
from core_models.walls import check_wall
from fem.elements import FULL, find_element, points_of
from meshes.quality import edge_lengths
from studies.bar_mesh import bar_mesh
from studies.display import number
from studies.effects import scene_effects
from studies.effects_study.decision_text import decisions_text
from studies.effects_study.decisions import decisions
from studies.methods import METHODS, planned_runs
from studies.scene import Scene
from studies.text_table import aligned
from studies.variants import read_variant

CRUSHED = {"fem-explicit": (2.5, 18.0), "mpm": (1.0, 1.5)}
"""By how much a run needs more steps than the undeformed bar: elements are crushed thin, a grid's cells are not."""
COURANT = {"fem-explicit": 0.9, "mpm": 0.5}


def plan_text(
    scene: Scene, methods: tuple[str, ...] | None, resolutions: tuple[int, ...] | None, wall: str | None
) -> str:
    """Scene, material, effects and, per run, mesh and estimated steps."""
    wall = check_wall(wall or scene.wall)
    bar = scene.bar
    parts = [
        f"{scene.name}: {scene.description}",
        f"bar      L0 {bar.length * 1e3:g} mm, R0 {bar.radius * 1e3:g} mm, "
        f"{-bar.velocity:g} m/s, {bar.temperature:g} K\n"
        f"wall     {wall}{_friction(scene)}\n"
        f"end      {_end(scene, wall)}\n"
        f"material {_laws(scene.material)}",
        aligned(_effect_rows(scene, wall, methods or tuple(METHODS))),
        "what the numbers ask for\n" + decisions_text(decisions(scene, wall)),
        aligned(_run_rows(scene, methods or tuple(METHODS), resolutions, wall)),
    ]
    if scene.bar.temperature >= melting_temperature(scene.material.melting):
        parts.append(
            f"remark: the bar begins at {bar.temperature:g} K, at or above its melting temperature, "
            f"{melting_temperature(scene.material.melting):g} K: it has no strength"
        )
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


def _run_rows(
    scene: Scene, methods: tuple[str, ...], resolutions: tuple[int, ...] | None, wall: str
) -> list[list[str]]:
    rows = [["run", "points", "smallest edge mm", "steps to the latest end, some"]]
    for method, resolution in planned_runs(scene, methods, resolutions):
        variant = read_variant(method)
        mesh = bar_mesh(scene, resolution, variant.kind, variant.elements_per_cell)
        is_grid = variant.solver == "mpm"
        edge = scene.bar.radius / resolution if is_grid else float(edge_lengths(mesh).min())
        steps = scene.end.limit(wall) * _wave_speed(scene) / (COURANT[variant.solver] * edge)
        low, high = (_rough(factor * steps) for factor in CRUSHED[variant.solver])
        element = find_element(mesh.kind, variant.options.get("integration", FULL))
        points = len(mesh.cells) * points_of(element)
        rows.append([f"{method} {resolution}", str(points), number(edge * 1e3, 3), f"{low} to {high}"])
    return rows


def _rough(count: float) -> int:
    """Two significant digits are all that an estimate can say."""
    return int(float(f"{count:.1e}"))


def _wave_speed(scene: Scene) -> float:
    bulk, shear = elastic_moduli(scene.material.elasticity)
    return sqrt((bulk + 4.0 / 3.0 * shear) / scene.material.density)

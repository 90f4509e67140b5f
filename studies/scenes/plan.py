"""What a scene would simulate, as numbers: runs with their points, edges and estimated steps."""

from dataclasses import asdict, dataclass
from typing import Any

from core_models.walls import check_wall
from fem.elements import FULL, find_element, points_of
from meshes.quality import edge_lengths
from studies.bar.mesh import bar_mesh
from studies.decisions.beforehand import decisions
from studies.methods.method import METHODS, planned_runs
from studies.methods.variants import read_variant
from studies.scenes.effects import scene_effects
from studies.scenes.remarks import scene_remarks
from studies.scenes.scene import Scene

CRUSHED = {"fem-explicit": (2.5, 18.0), "mpm": (1.0, 1.5)}
"""By how much a run needs more steps than the undeformed bar: elements are crushed thin, a grid's cells are not."""
COURANT = {"fem-explicit": 0.9, "mpm": 0.5}


@dataclass(frozen=True)
class PlannedRun:
    """One run: its points, smallest edge [m], first step [s], and between how many it takes to the latest end, some."""

    method: str
    resolution: int
    points: int
    smallest_edge: float
    first_step: float
    fewest_steps: int
    most_steps: int


def plan_of(
    scene: Scene, methods: tuple[str, ...] | None, resolutions: tuple[int, ...] | None, wall: str
) -> list[PlannedRun]:
    """All runs of a scene by some methods (default: both) at some resolutions (default: the scene's)."""
    runs = planned_runs(scene, methods or tuple(METHODS), resolutions)
    return [_planned(scene, method, resolution, wall) for method, resolution in runs]


def plan_record(
    scene: Scene, methods: tuple[str, ...] | None, resolutions: tuple[int, ...] | None, wall: str | None
) -> dict[str, Any]:
    """Scene, material, effects, decisions, runs and remarks as plain data."""
    wall = check_wall(wall or scene.wall)
    effects = scene_effects(scene, wall, methods or tuple(METHODS))
    runs = plan_of(scene, methods, resolutions, wall)
    return {
        "scene": scene.name,
        "description": scene.description,
        "wall": wall,
        "bar": asdict(scene.bar),
        "latest_end": scene.end.limit(wall),
        "laws": {type(law).__name__: law for law in scene.material.laws},
        "effects": [{"name": each.name, "on": each.on, "reason": each.reason} for each in effects],
        "decisions": [asdict(each) | {"wanted": each.wanted} for each in decisions(scene, wall)],
        "runs": [asdict(each) for each in runs],
        "remarks": scene_remarks(scene, wall, [run.first_step for run in runs]),
        "unused_tags": list(scene.unused),
    }


def _planned(scene: Scene, method: str, resolution: int, wall: str) -> PlannedRun:
    variant = read_variant(method)
    mesh = bar_mesh(scene, resolution, variant.kind, variant.elements_per_cell)
    is_grid = variant.solver == "mpm"
    edge = scene.bar.radius / resolution if is_grid else float(edge_lengths(mesh).min())
    step = COURANT[variant.solver] * edge / scene.wave_speed
    low, high = (_rough(factor * scene.end.limit(wall) / step) for factor in CRUSHED[variant.solver])
    element = find_element(mesh.kind, variant.options.get("integration", FULL))
    return PlannedRun(method, resolution, len(mesh.cells) * points_of(element), edge, step, low, high)


def _rough(count: float) -> int:
    """Two significant digits are all that an estimate can say; no run makes less than one step."""
    return max(int(float(f"{count:.1e}")), 1)

"""The effects study: a scene as it is, then with each effect switched: what that costs and changes."""

from collections.abc import Callable
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from core_models.errors import MatpointError
from core_models.walls import check_wall
from studies.decisions.beforehand import decisions
from studies.effects_study.off import cost_of_off
from studies.effects_study.switched import AS_IT_IS, Switched
from studies.effects_study.switches import SWITCHES
from studies.effects_study.tables import FIELDS, report_of
from studies.methods.method import build_solver, check_run
from studies.output.output_folder import OutputFolder
from studies.output.versions import processor, versions
from studies.report.study_page import Report, write_report
from studies.runs.record import to_json
from studies.scenes.scene import Scene
from studies.work_precision.bars import finish_bar, with_fixed_end
from studies.work_precision.measurement import Measurement, measure_run

SPATIAL = "three dimensions"


@dataclass(frozen=True)
class Outcome:
    """All runs, of each method the scene as it is first; remark : what could not be written, or nothing."""

    runs: list[Switched]
    report: Report
    remark: str


def planned(scene: Scene, method: str, spatial: bool) -> list[tuple[str, str, str, Scene]]:
    """Effect, what it is switched to, method and scene of each run."""
    plan = [(AS_IT_IS, "", method, scene)]
    for switch in SWITCHES:
        switched = switch.switched(scene)
        if switched is not None:
            plan.append((switch.effect, switched[0], method, switched[1]))
    if spatial and ":" not in method:
        plan.append((SPATIAL, "on", f"{method}:{'spatial' if method == 'mpm' else 'hex8'}", scene))
    return plan


def compare_effects(
    scene: Scene,
    out: Path | str,
    *,
    methods: tuple[str, ...] = ("fem-explicit", "mpm"),
    resolution: int = 8,
    wall: str | None = None,
    repeats: int = 3,
    spatial: bool = True,
    tell: Callable[[Switched], None] = lambda run: None,
) -> Outcome:
    """Measure all and write results.json, tables as CSV, report.html and report.md.

    A scene that ends with release is compared at the end time of its plane wall, the same for all runs.
    Raises SceneError for unknown methods, OutputError for a folder in use before anything is run.
    """
    wall = check_wall(wall or scene.wall)
    scene = with_fixed_end(scene)
    for method in methods:
        check_run(scene, method, resolution)
    with OutputFolder(out) as folder:
        runs = []
        for method in methods:
            for effect, to, variant, switched in planned(scene, method, spatial):
                runs.append(
                    Switched(effect, to, method, _measure(switched, variant, resolution, wall, repeats))
                )
                tell(runs[-1])
        offs = []
        for method in methods:
            try:
                offs.append(cost_of_off(scene, method, resolution, wall))
            except MatpointError as reason:
                failed = Measurement(method, resolution, message=str(reason))
                runs.append(Switched("all effects", "off", method, failed))
        found = decisions(scene, wall)
        report = report_of(scene, wall, runs, found, resolution, offs)
        record = [{"effect": r.effect, "to": r.to, "method": r.method, "run": r.run.as_json()} for r in runs]
        folder.write_text(
            "results.json",
            to_json(
                {
                    "study": "effects",
                    "runs": record,
                    "off": [asdict(each) for each in offs],
                    "versions": versions(),
                    "processor": processor(),
                }
            ),
        )
        remark = write_report(report, folder)
    return Outcome(runs, report, remark)


def _measure(scene: Scene, variant: str, resolution: int, wall: str, repeats: int) -> Measurement:
    def finish(solver: Any) -> dict[str, float]:
        return finish_bar(solver, scene.end.limit(wall)) | largest_values(solver)

    return measure_run(
        variant, resolution, lambda: build_solver(scene, variant, resolution, wall, 1), finish, repeats
    )


def largest_values(solver: Any) -> dict[str, float]:
    """Largest plastic strain and temperature [K] where there are such."""
    fields = solver.points.fields()
    return {name: float(fields[of].array.max()) for name, of in FIELDS.items() if of in fields}

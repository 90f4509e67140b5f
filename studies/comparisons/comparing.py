"""Running a comparison: every method at every resolution, results.json, report."""

import shutil
from dataclasses import asdict
from pathlib import Path
from typing import Any

from core_models.compilation import source_hash
from core_models.errors import DiskFull, UnsupportedError
from core_models.walls import check_wall
from studies.checkpointing.checkpoint_file import FILE as CHECKPOINT
from studies.checkpointing.resuming import go_on
from studies.comparisons.comparison import Comparison, conclude
from studies.comparisons.kept_run import keep_run, kept_run
from studies.methods.method import planned_runs
from studies.output.output_folder import OutputFolder, ResumedFolder
from studies.output.study_folder import study_folder
from studies.output.versions import processor, versions
from studies.report.comparison_report import report_of
from studies.report.study_page import write_report
from studies.runs.record import run_entry, to_json
from studies.runs.remaining import Remaining
from studies.runs.result import RunResult
from studies.runs.running import simulate
from studies.scenes.scene import Scene


def compare(
    scene: Scene,
    methods: tuple[str, ...] = ("fem-explicit", "mpm"),
    resolutions: tuple[int, ...] | None = None,
    *,
    wall: str | None = None,
    threads: int = 1,
    out: Path | str | None = None,
    progress: bool = False,
    going_on: bool = False,
) -> Comparison:
    """Run a scene by every method at every resolution under one wall and compare.

    resolutions: elements or cells across the radius (default: the scene's own for each method), each run once;
    out: folder for results.json, report.html, report.md, tables as CSV and one subfolder per run (default: nothing is
    written). A run that goes wrong is recorded with its message and does not stop the others. going_on: `out` is the
    folder of the same comparison, which was stopped: complete runs in it are kept, one that was stopped goes on from
    its checkpoint.
    Raises SceneError, MeshError, OutputError before anything is written.
    """
    wall = check_wall(wall or scene.wall)
    plan = planned_runs(scene, methods, resolutions)
    options = {"threads": threads, "progress": progress, "remaining": Remaining(plan)}
    if out is None:
        return conclude(scene, wall, [_one(scene, *job, wall, None, options) for job in plan])
    settings = {
        "study": "comparison", "scene": scene.name, "wall": wall, "runs": plan, "threads": threads,
        "sources": source_hash(),
    }  # fmt: skip
    with study_folder(out, settings, going_on) as folder:
        runs = [_one(scene, *job, wall, folder, options) for job in plan]
        comparison = conclude(scene, wall, runs)
        folder.write_text("results.json", to_json(results(comparison)))
        _maps(comparison, folder)
        _report(comparison, folder)
    return comparison


def _maps(comparison: Comparison, folder: OutputFolder) -> None:
    """Both fields and their difference over the undeformed bar, and on the first method's final shape."""
    if comparison.maps is None:
        return
    from meshes.io import write_domains_vtu

    maps, data = comparison.maps, comparison.maps.cell_data()
    write_domains_vtu(folder.file("difference.vtu"), maps.cells, data)
    final = comparison.finest[0].final
    deformed = {name: values[maps.cell_of] for name, values in data.items()}
    write_domains_vtu(folder.file("difference-deformed.vtu"), final.domains, deformed)


def _report(comparison: Comparison, folder: OutputFolder) -> None:
    try:
        comparison.notice = write_report(report_of(comparison), folder)
    except UnsupportedError as reason:
        comparison.notice = f"{reason}; results.json is complete"


def results(comparison: Comparison) -> dict:
    """The content of results.json."""
    return {
        "scene": comparison.scene.name,
        "description": comparison.scene.description,
        "wall": comparison.wall,
        "runs": [run_entry(run) for run in comparison.runs],
        "limits": {m: {q: asdict(e) for q, e in of.items()} for m, of in comparison.limits.items()},
        "differences": [asdict(each) for each in comparison.differences],
        "fields": [] if comparison.maps is None else [asdict(each) for each in comparison.maps.gaps],
        "profiles": [asdict(each) for each in comparison.profiles],
        "references": [asdict(each) for each in comparison.references],
        "versions": versions(),
        "processor": processor(),
    }


def _one(
    scene: Scene,
    method: str,
    resolution: int,
    wall: str,
    folder: OutputFolder | None,
    options: dict[str, Any],
) -> RunResult:
    """A run, as it was kept or made now; options : threads, progress and remaining of `simulate`."""
    kept = None
    if folder is not None:
        kept = kept_run(
            _place(folder, method, resolution), scene, method, resolution, wall, options["threads"]
        )
    result = kept or _made(scene, method, resolution, wall, folder, options)
    options["remaining"].end(made=kept is None)
    return result


def _place(folder: OutputFolder, method: str, resolution: int) -> Path:
    return folder.path / f"{method.replace(':', '-')}-{resolution}"


def _made(
    scene: Scene,
    method: str,
    resolution: int,
    wall: str,
    folder: OutputFolder | None,
    options: dict[str, Any],
) -> RunResult:
    if folder is None:
        return simulate(scene, method, resolution, wall=wall, **options)
    place = _place(folder, method, resolution)
    if (place / CHECKPOINT).exists():
        with ResumedFolder(place) as own:
            going_on = {name: options[name] for name in ("progress", "remaining")}
            return _kept(go_on(own, **going_on), own)
    if place.exists():
        shutil.rmtree(place)
    with folder.subfolder(place.name) as own:
        return _kept(simulate(scene, method, resolution, wall=wall, folder=own, **options), own)


def _kept(result: RunResult, folder: OutputFolder) -> RunResult:
    if result.failure is None:
        try:
            keep_run(result, folder)
        except DiskFull as failure:
            result.failure = failure
    return result

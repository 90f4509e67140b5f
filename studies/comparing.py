"""Running a comparison: every method at every resolution, results.json, report."""

from dataclasses import asdict
from pathlib import Path

from core_models.errors import UnsupportedError
from core_models.walls import check_wall
from studies.comparison import Comparison, conclude
from studies.methods import planned_runs
from studies.output_folder import OutputFolder
from studies.report.comparison_report import report_of
from studies.report.study_page import write_report
from studies.run_record import run_entry, to_json
from studies.run_result import RunResult
from studies.running import simulate
from studies.scene import Scene
from studies.versions import processor, versions


def compare(
    scene: Scene,
    methods: tuple[str, ...] = ("fem-explicit", "mpm"),
    resolutions: tuple[int, ...] | None = None,
    *,
    wall: str | None = None,
    threads: int = 1,
    out: Path | str | None = None,
    progress: bool = False,
) -> Comparison:
    """Run a scene by every method at every resolution under one wall and compare.

    resolutions: elements or cells across the radius (default: the scene's own for each method), each run once;
    out: folder for results.json, report.html, report.md, tables as CSV and one subfolder per run (default: nothing is
    written). A run that goes wrong is recorded with its message and does not stop the others.
    Raises SceneError, MeshError, OutputError before anything is written.
    """
    wall = check_wall(wall or scene.wall)
    plan = planned_runs(scene, methods, resolutions)
    if out is None:
        return conclude(scene, wall, [_one(scene, *job, wall, threads, None, progress) for job in plan])
    with OutputFolder(out) as folder:
        runs = [_one(scene, *job, wall, threads, folder, progress) for job in plan]
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
    threads: int,
    folder: OutputFolder | None,
    progress: bool,
) -> RunResult:
    options = {"wall": wall, "threads": threads, "progress": progress}
    if folder is None:
        return simulate(scene, method, resolution, **options)
    with folder.subfolder(f"{method.replace(':', '-')}-{resolution}") as own:
        return simulate(scene, method, resolution, folder=own, **options)

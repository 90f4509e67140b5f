"""The work-precision study: every variant at five or more resolutions, what each costs and gives."""

import os
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from core_models.errors import SceneError
from core_models.names import suggestion
from studies.output.output_folder import OutputFolder
from studies.output.study_folder import keep, kept, study_folder
from studies.output.versions import processor, versions
from studies.report.study_page import Report, write_report
from studies.runs.record import to_json
from studies.scenes.shipped import shipped_scenes
from studies.work_precision import necking, vibration, vortex
from studies.work_precision.bars import bar_problem
from studies.work_precision.measurement import Measurement, measure_run
from studies.work_precision.problem import WorkProblem
from studies.work_precision.tables import report_of

PROBLEMS = {"vibrating-bar": vibration.PROBLEM, "vortex": vortex.PROBLEM, "necking-simo": necking.PROBLEM}
FEWEST = 5
LIKE = "like 4,6,8,12,16"
REPEATS = 3


@dataclass(frozen=True)
class Outcome:
    """All measurements and their report; remark : what could not be written, or nothing."""

    runs: list[Measurement]
    report: Report
    remark: str


def find_problem(name: str, wall: str | None = None) -> WorkProblem:
    """The problem of a name: one of PROBLEMS, or an impact scene, shipped or in a file, under a wall.

    Raises SceneError naming the nearest one; CardError for a scene's file that cannot be read.
    """
    if name in PROBLEMS:
        if wall is not None:
            raise SceneError(f"{name} has no wall: leave --wall out")
        return PROBLEMS[name]
    if name not in shipped_scenes() and Path(name).suffix != ".xml":
        known = [*PROBLEMS, *shipped_scenes()]
        raise SceneError(f"no problem or scene is called {name!r}; {suggestion(name, known)}")
    return bar_problem(name, wall)


def planned(
    problem: WorkProblem, variants: tuple[str, ...] | None, resolutions: tuple[int, ...] | None
) -> list[tuple[str, int]]:
    """Every variant once at every resolution, coarse to fine.

    Raises SceneError for fewer than five resolutions, one of 0, or one that is given more than once.
    """
    if resolutions is not None:
        _check(resolutions)
    chosen = variants or problem.variants
    return [
        (variant, resolution)
        for variant in dict.fromkeys(chosen)
        for resolution in sorted(resolutions or _resolutions(problem, variant))
    ]


def _check(resolutions: tuple[int, ...]) -> None:
    twice = next((each for each in resolutions if resolutions.count(each) > 1), None)
    if min(resolutions) < 1:
        raise SceneError(f"a resolution of 0 has no cells: give 1 or more, {LIKE}")
    if twice is not None:
        raise SceneError(
            f"resolution {twice} is given more than once: give {FEWEST} or more different ones, {LIKE}"
        )
    if len(resolutions) < FEWEST:
        few = f"{len(resolutions)} resolutions show" if len(resolutions) > 1 else "1 resolution shows"
        raise SceneError(f"{few} no order: give {FEWEST} or more, {LIKE}")


def _resolutions(problem: WorkProblem, variant: str) -> tuple[int, ...]:
    method = problem.read(variant).solver
    return problem.resolutions.get(variant, problem.resolutions[method])


def compare_work(
    problem: WorkProblem,
    out: Path | str,
    *,
    variants: tuple[str, ...] | None = None,
    resolutions: tuple[int, ...] | None = None,
    repeats: int = REPEATS,
    threads: int | None = None,
    going_on: bool = False,
    tell: Callable[[Measurement], None] = lambda run: None,
) -> Outcome:
    """Measure all and write results.json, tables as CSV, report.html and report.md.

    Runs are made one after the other in this process, on one thread; the finest of each variant once more on `threads`
    (default: all that there are). going_on : `out` is the folder of the same study, which was stopped; what it holds is
    not measured again. tell : called with each.
    Raises SceneError for unknown variants and OutputError for a folder in use before anything is run.
    """
    plan = [(*job, 1) for job in planned(problem, variants, resolutions)]
    threads = threads or len(os.sched_getaffinity(0))
    if threads > 1:
        finest = {variant: resolution for variant, resolution, _ in plan}
        plan += [(variant, resolution, threads) for variant, resolution in finest.items()]
    settings = {"study": "work-precision", "problem": problem.name, "repeats": repeats, "plan": plan}
    with study_folder(out, settings, going_on) as folder:
        runs = []
        for job in plan:
            runs.append(_measured(problem, job, repeats, folder))
            tell(runs[-1])
        report = report_of(problem, runs, repeats)
        record = {
            "study": "work-precision",
            "problem": problem.name,
            "repeats": repeats,
            "runs": [run.as_json() for run in runs],
            "versions": versions(),
            "processor": processor(),
        }
        folder.write_text("results.json", to_json(record))
        remark = write_report(report, folder)
    return Outcome(runs, report, remark)


def _measured(
    problem: WorkProblem, job: tuple[str, int, int], repeats: int, folder: OutputFolder
) -> Measurement:
    variant, resolution, threads = job
    key = f"{variant}-{resolution}-threads-{threads}"
    before = kept(folder, key)
    if before is not None:
        return Measurement(**before)
    run = measure_run(variant, resolution, lambda: problem.build(*job), problem.finish, repeats, threads)
    keep(folder, key, run.as_json())
    return run

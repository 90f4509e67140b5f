"""The necking study: the runs of a scene by the methods asked for, its checks, one report."""

from collections.abc import Callable, Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any

from core_models.errors import SceneError
from core_models.names import suggestion
from studies.necking.methods import METHODS
from studies.necking.outcome import outcome_of
from studies.necking.pictures import final_shapes
from studies.necking.reader import fingerprint, read_necking_scene
from studies.necking.record import asked, perform_run, run_from
from studies.necking.scene import NeckingScene, PlannedRun
from studies.necking.verdicts import Runs
from studies.output.output_folder import OutputFolder
from studies.output.study_folder import KEPT, forget, kept, study_folder
from studies.output.versions import versions
from studies.report.study_page import AGREE, APART, Report, Section, Verdict, write_report
from studies.runs.record import to_json
from studies.sweep.job import COMPLETE, Job
from studies.sweep.sweep import run_sweep
from studies.verification.outcome import Outcome
from studies.verification.study import plain
from studies.verification.text import criterion_text


def planned(scene: NeckingScene, methods: Sequence[str] | None, quick: bool) -> list[PlannedRun]:
    """The runs of a scene that are asked for, extra ones by name; SceneError for a method or run it does not have."""
    for method in methods or ():
        known = {*METHODS, *(plan.name for plan in scene.runs)}
        if method not in known:
            wrong = f"no method or run is called {method!r}" if method else "no method given"
            raise SceneError(f"{wrong}; {suggestion(method, known)}")
    plans = [plan for plan in scene.runs if _wanted(plan, methods) and (plan.quick or not quick)]
    if not plans:
        there = sorted({plan.method for plan in scene.runs if plan.quick or not quick})
        by = f" by {', '.join(methods)}" if methods else ""
        raise SceneError(
            f"{scene.name} has no {'quick ' if quick else ''}run{by}; "
            + (f"there are runs by {', '.join(there)}" if there else 'give one quick="yes"')
        )
    return plans


def _wanted(plan: PlannedRun, methods: Sequence[str] | None) -> bool:
    by_method = methods is None or plan.method in methods
    return (by_method and not plan.extra) or plan.name in (methods or ())


def study_necking(
    name: str | Path,
    out: Path | str,
    *,
    methods: Sequence[str] | None = None,
    quick: bool = False,
    going_on: bool = False,
    workers: int | None = None,
    tell: Callable[[dict[str, Any], int, int], None] = lambda result, done, all_: None,
) -> Outcome:
    """Make the runs and write runs/*.json, results.json and report.html.

    going_on : `out` is the folder of a study of the same scene that was stopped; its complete runs are kept, and the
    others go on from where they were.
    tell : called with each result, how many there are by now, and how many there will be.
    Raises SceneError or CardError for what cannot be run, OutputError for a folder that is in use or another study's.
    """
    scene = read_necking_scene(name)
    plans = planned(scene, methods, quick)
    settings = {"study": "necking", "scene": scene.name, "fingerprint": fingerprint(name)}
    with study_folder(out, settings, going_on) as folder:
        results = dict(
            zip((plan.name for plan in plans), _made(name, plans, folder, workers, tell), strict=True)
        )
        runs = {name: run_from(each) for name, each in results.items() if "rows" in each}
        failures = {name: each["message"] for name, each in results.items() if each["status"] != COMPLETE}
        outcome = outcome_of(scene, runs, failures)
        entry = {"study": "necking", "quick": quick, "scene": scene.name, "source": scene.source}
        entry |= asdict(outcome) | {"met": [criterion.met for criterion in outcome.criteria]}
        folder.write_text("results.json", to_json(plain(entry | {"versions": versions()})))
        remark = write_report(_report(scene, outcome, runs, quick), folder)
        if remark:
            outcome.remarks.append(remark)
    return outcome


def _made(
    name: str | Path, plans: Sequence[PlannedRun], folder: OutputFolder, workers: int | None, tell: Callable
) -> list[dict[str, Any]]:
    """Results of all runs; those that the folder holds whole are not made again, others go on from their states."""
    states, jobs = {}, []
    for plan in plans:
        key = plan.name.replace(":", "-")
        before = kept(folder, key)
        if before is not None and before["status"] == COMPLETE and before["asked"] != asked(plan):
            forget(folder, key)
        states[key] = folder.file(f"{KEPT}/{key}.npz")
        jobs.append(Job(key, perform_run, (str(name), plan.name, str(states[key]))))

    def done(result: dict[str, Any], number: int, all_: int) -> None:
        if result["status"] == COMPLETE:
            states[result["key"]].unlink(missing_ok=True)
        tell(result, number, all_)

    return run_sweep(jobs, folder, workers=workers, tell=done)


def _report(scene: NeckingScene, outcome: Outcome, runs: Runs, quick: bool) -> Report:
    met = sum(criterion.met for criterion in outcome.criteria)
    verdicts = tuple(
        Verdict(AGREE if each.met else APART, criterion_text(each))
        for each in sorted(outcome.criteria, key=lambda each: each.met)
    )
    facts = (
        f"{met} of {len(outcome.criteria)} criteria met",
        f"{len(runs)} runs",
        f"{outcome.seconds:.0f} s of processor time",
        "quick" if quick else "full",
    )
    tables = tuple(each for each in outcome.tables if each.rows)
    sections = (
        Section(scene.name, "What came out", plots=tuple(outcome.plots), verdicts=verdicts),
        Section("shapes", "Final shapes", figures=tuple(final_shapes(scene, runs))),
        Section("numbers", "Numbers", tables, remarks=tuple(outcome.remarks)),
    )
    return Report(scene.title, f"{scene.description} Source: {scene.source}.", facts, sections)

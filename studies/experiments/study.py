"""The study of the experiments: every shot by every flow law that has constants and both methods."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from studies.experiments.predictions import CARDS, predict
from studies.experiments.shots import read_shots
from studies.experiments.tables import sections
from studies.output.study_folder import study_folder
from studies.output.versions import processor, versions
from studies.report.study_page import Report, write_report
from studies.runs.record import to_json
from studies.sweep.job import COMPLETE, Job
from studies.sweep.sweep import check_scheduler, run_sweep


@dataclass(frozen=True)
class Extent:
    """How much is run: elements or cells across the radius by method, cards of each metal, seconds for each run."""

    resolutions: tuple[tuple[str, int], ...]
    cards: int
    within: float


FULL = Extent((("fem-explicit", 4), ("mpm", 8)), 9, 40.0)
QUICK = Extent((("fem-explicit", 3), ("mpm", 6)), 1, 20.0)


@dataclass(frozen=True)
class Outcome:
    """All results, in the order of the shots, their report; remark : what could not be written, or nothing."""

    results: list[dict[str, Any]]
    report: Report
    remark: str

    @property
    def failed(self) -> int:
        """How many runs went wrong."""
        return sum(result["status"] != COMPLETE for result in self.results)


def jobs_of(extent: Extent) -> list[Job]:
    """One job for each shot, card and method."""
    return [
        Job(
            f"{shot.name}--{card}--{method}-{resolution}",
            predict,
            (shot.name, card, method, resolution, extent.within),
        )
        for shot in read_shots()
        for card in CARDS[shot.material][: extent.cards]
        for method, resolution in extent.resolutions
    ]


def compare_experiments(
    out: Path | str,
    *,
    quick: bool = False,
    going_on: bool = False,
    scheduler: str | None = None,
    workers: int | None = None,
    only: Callable[[Job], bool] = lambda job: True,
    tell: Callable[[dict[str, Any], int, int], None] = lambda result, done, all_: None,
) -> Outcome:
    """Run all shots and write runs/*.json, results.json, tables as CSV, report.html and report.md.

    going_on : `out` is the folder of a study that was stopped; runs in it that are complete are kept.
    scheduler, workers, tell : see `studies.sweep.sweep`. only : which jobs to do.
    Raises OutputError for a folder that is in use, or that another study has been started in, and before anything is
    written what `studies.sweep.sweep.check_scheduler` does.
    """
    check_scheduler(scheduler)
    extent = QUICK if quick else FULL
    settings = {"study": "experiments", "quick": quick}
    with study_folder(out, settings, going_on) as folder:
        jobs = [job for job in jobs_of(extent) if only(job)]
        results = run_sweep(jobs, folder, scheduler=scheduler, workers=workers, tell=tell)
        record = {**settings, "results": results, "versions": versions(), "processor": processor()}
        folder.write_text("results.json", to_json(record))
        report = _report(results, extent, quick)
        remark = write_report(report, folder)
    return Outcome(results, report, remark)


def _report(results: list[dict[str, Any]], extent: Extent, quick: bool) -> Report:
    sizes = ", ".join(f"{method} {resolution} across the radius" for method, resolution in extent.resolutions)
    done = sum(result["status"] == COMPLETE for result in results)
    lead = (
        "Taylor shots of copper, aluminium and steel: what the flow laws predict with constants from elsewhere, none "
        "fitted to these shots, by finite elements and by the material point method."
    )
    facts = (f"{done} of {len(results)} runs complete", sizes, "quick: one card a metal" if quick else "full")
    methods = tuple(method for method, _ in extent.resolutions)
    return Report("Taylor impact experiments", lead, facts, sections(results, methods))

"""The stability study: every hard case by every variant that it suits."""

import os
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from core_models.errors import SceneError
from studies.output.study_folder import keep, kept, study_folder
from studies.output.versions import processor, versions
from studies.report.study_page import Report, write_report
from studies.runs.record import to_json
from studies.stability.case import Case
from studies.stability.cases import all_cases, find_case
from studies.stability.cell import FAILED
from studies.stability.isolated import TIME_LIMIT, Task, results_of, run_isolated
from studies.stability.tables import report_of
from studies.stability.true_limit import true_limit
from studies.stability.variants import EXPLICIT, IMPLICIT, is_implicit

VARIANTS = (*EXPLICIT, *IMPLICIT)


@dataclass(frozen=True)
class Outcome:
    """All cells as plain data, their report; remark : what could not be written, or nothing."""

    cells: list[dict[str, Any]]
    report: Report
    remark: str

    @property
    def failed(self) -> int:
        """How many cells have failed."""
        return sum(cell["verdict"] == FAILED for cell in self.cells)


def survey_stability(
    out: Path | str,
    *,
    quick: bool = False,
    cases: tuple[str, ...] | None = None,
    variants: tuple[str, ...] | None = None,
    going_on: bool = False,
    workers: int | None = None,
    run: Callable[[list[tuple[str, str]], bool, int], Iterable[dict[str, Any]]] = run_isolated,
    tell: Callable[[dict[str, Any]], None] = lambda cell: None,
) -> Outcome:
    """Run the matrix, each cell in a process of its own, and write results.json, tables, report.html and report.md.

    quick : a tenth of the steps. going_on : `out` is the folder of a study that was stopped; cells in it are kept.
    workers : how many cells at a time, by default one for each processor.
    The true limits of the steps are looked for where all cases are run.
    Raises SceneError for unknown cases and variants, OutputError for a folder in use or of another study.
    """
    chosen = [find_case(name) for name in cases] if cases else list(all_cases().values())
    methods = variants or VARIANTS
    workers = workers or len(os.sched_getaffinity(0))
    matrix = pairs(chosen, methods)
    settings = {"study": "stability", "quick": quick, "cases": cases, "variants": methods}
    with study_folder(out, settings, going_on) as folder:
        known = {cell: kept(folder, _key(*cell)) for cell in matrix}
        for found in known.values():
            if found:
                tell(found)
        for found in run([cell for cell in matrix if not known[cell]], quick, workers):
            cell = found["case"], found["variant"]
            known[cell] = found
            keep(folder, _key(*cell), found)
            tell(found)
        cells = [known[cell] for cell in matrix]
        limits = {} if cases else true_limits([name for name in methods if not is_implicit(name)], workers)
        record = {
            "study": "stability",
            "quick": quick,
            "cells": cells,
            "limits": limits,
            "versions": versions(),
        }
        folder.write_text("results.json", to_json(record | {"processor": processor()}))
        report = report_of(cells, quick, limits)
        remark = write_report(report, folder)
    return Outcome(cells, report, remark)


def pairs(cases: Iterable[Case], variants: tuple[str, ...]) -> list[tuple[str, str]]:
    """Names of case and variant of every cell: cases of increments by implicit variants, the others by explicit ones.

    Raises SceneError where no case suits any variant.
    """
    found = [
        (case.name, variant)
        for case in cases
        for variant in variants
        if case.implicit == is_implicit(variant)
    ]
    if not found:
        raise SceneError(
            "none of these cases is for any of these methods: cases of increments (implicit-...) take fem-implicit and "
            "mpm-implicit, the others fem-explicit and mpm"
        )
    return found


def true_limits(variants: Sequence[str], workers: int) -> dict[str, float | None]:
    """The true limit of each variant's step over its estimate; None where a process could not find it."""
    tasks = [
        Task("true limit", name, lambda name=name: {"variant": name, "limit": true_limit(name)})
        for name in variants
    ]
    found = {result["variant"]: result.get("limit") for result in results_of(tasks, TIME_LIMIT, workers)}
    return {name: found[name] for name in variants}


def _key(case: str, variant: str) -> str:
    return f"{case}--{variant}"

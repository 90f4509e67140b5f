"""The stability study: every hard case by every variant."""

from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from studies.report.study_page import Report, Section, write_report
from studies.run_record import to_json
from studies.stability.cases import all_cases, find_case
from studies.stability.cell import FAILED, REFUSED, RESCUED, STABLE
from studies.stability.isolated import TIME_LIMIT, judged, run_isolated
from studies.stability.true_limit import HIGHEST, STEPS, true_limit
from studies.study_folder import keep, kept, study_folder
from studies.variants import read_variant
from studies.verification.outcome import Table
from studies.versions import processor, versions

VARIANTS = (
    "fem-explicit",
    "fem-explicit:reduced",
    "fem-explicit:tri3",
    "fem-explicit:quad8",
    "mpm",
    "mpm:flip",
    "mpm:linear",
    "mpm:cubic",
    "mpm:cpdi",
    "mpm:total",
)
MARKS = {STABLE: "stable", RESCUED: "redone", REFUSED: "refused", FAILED: "FAILED"}


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
    run: Callable[[str, str, bool], dict[str, Any]] = run_isolated,
    tell: Callable[[dict[str, Any]], None] = lambda cell: None,
) -> Outcome:
    """Run the matrix, each cell in a process of its own, and write results.json, tables, report.html and report.md.

    quick : a tenth of the steps. going_on : `out` is the folder of a study that was stopped; cells in it are kept.
    The true limits of the steps are looked for where all cases are run.
    Raises SceneError for unknown cases and variants, OutputError for a folder in use or of another study.
    """
    chosen = [find_case(name) for name in cases] if cases else list(all_cases().values())
    for variant in variants or ():
        read_variant(variant)
    methods = variants or VARIANTS
    settings = {"study": "stability", "quick": quick, "cases": cases, "variants": methods}
    with study_folder(out, settings, going_on) as folder:
        cells = []
        for case in chosen:
            for variant in methods:
                key = f"{case.name}--{variant}"
                cells.append(kept(folder, key) or run(case.name, variant, quick))
                keep(folder, key, cells[-1])
                tell(cells[-1])
        limits = {} if cases else {variant: limit_of(variant) for variant in methods}
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


def limit_of(variant: str) -> float | None:
    """The true limit of a variant's step over its estimate; None where a process could not find it."""
    return judged("true limit", variant, lambda: {"limit": true_limit(variant)}, TIME_LIMIT).get("limit")


def report_of(cells: list[dict[str, Any]], quick: bool, limits: dict[str, float | None]) -> Report:
    """The matrix, why cells were refused or failed, the true limits of steps, and every number."""
    counts = Counter(cell["verdict"] for cell in cells)
    facts = (
        *(f"{counts[verdict]} {verdict}" for verdict in MARKS),
        "a tenth of the steps" if quick else "full",
    )
    lead = (
        "Hard cases by variants of both methods. Refused: by a typed error that says what to do; failed: a number that "
        "is none, an energy that is off by more than a tenth, a crash, or a run that does not end."
    )
    said = [cell for cell in cells if cell["verdict"] in (REFUSED, FAILED)]
    reasons = tuple(
        (f"{cell['case']}, {cell['variant']}", MARKS[cell["verdict"]], cell["why"]) for cell in said
    )
    return Report(
        "Stability",
        lead,
        facts,
        (
            Section("matrix", "The matrix", (_matrix(cells),)),
            Section(
                "reasons", "What was said", (Table("Refused and failed", ("cell", "", "message"), reasons),)
            ),
            Section("limits", "True limit of the step", (_limits(limits),)),
            Section("cells", "Every cell", (_numbers(cells),)),
        ),
    )


def _matrix(cells: list[dict[str, Any]]) -> Table:
    variants = tuple(dict.fromkeys(cell["variant"] for cell in cells))
    marks = {(cell["case"], cell["variant"]): MARKS[cell["verdict"]] for cell in cells}
    names = dict.fromkeys(cell["case"] for cell in cells)
    rows = tuple((name, *(marks.get((name, variant)) for variant in variants)) for name in names)
    titles = "; ".join(f"{name}: {find_case(name).title}" for name in names)
    return Table("Cases by variants", ("case", *variants), rows, titles)


def _limits(limits: dict[str, float | None]) -> Table:
    note = (
        f"Of an elastic bar that swings, by bisection to 2 %, {STEPS} steps each; {HIGHEST:g}: that or more. "
        "Usual steps are 0.9 (finite elements) and 0.5 (material points) of the estimate."
    )
    return Table("Largest stable step over the estimate", ("variant", "ratio"), tuple(limits.items()), note)


def _numbers(cells: list[dict[str, Any]]) -> Table:
    head = (
        "cell",
        "verdict",
        "steps",
        "t [s]",
        "energy off [%]",
        "smallest J",
        "smallest step [s]",
        "redone",
    )
    rows = tuple(
        (
            f"{cell['case']}, {cell['variant']}",
            cell["verdict"],
            cell["steps"],
            cell["time"],
            None if cell["drift"] is None else 100.0 * cell["drift"],
            cell["smallest_ratio"],
            cell["smallest_step"],
            cell["redone"],
        )
        for cell in cells
    )
    return Table("Numbers", head, rows)

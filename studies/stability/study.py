"""The stability study: every hard case by every variant."""

from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from studies.output_folder import OutputFolder
from studies.report.study_page import Report, Section, write_report
from studies.run_record import to_json
from studies.stability.cases import all_cases, find_case
from studies.stability.cell import FAILED, REFUSED, RESCUED, STABLE
from studies.stability.isolated import run_isolated
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
    run: Callable[[str, str, bool], dict[str, Any]] = run_isolated,
    tell: Callable[[dict[str, Any]], None] = lambda cell: None,
) -> Outcome:
    """Run the matrix, each cell in a process of its own, and write results.json, tables, report.html and report.md.

    quick : a tenth of the steps. Raises SceneError for unknown cases and variants, OutputError for a folder in use.
    """
    chosen = [find_case(name) for name in cases] if cases else list(all_cases().values())
    for variant in variants or ():
        read_variant(variant)
    with OutputFolder(out) as folder:
        cells = []
        for case in chosen:
            for variant in variants or VARIANTS:
                cells.append(run(case.name, variant, quick))
                tell(cells[-1])
        record = {"study": "stability", "quick": quick, "cells": cells, "versions": versions()}
        folder.write_text("results.json", to_json(record | {"processor": processor()}))
        report = report_of(cells, quick)
        remark = write_report(report, folder)
    return Outcome(cells, report, remark)


def report_of(cells: list[dict[str, Any]], quick: bool) -> Report:
    """The matrix, why cells were refused or failed, and every number."""
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

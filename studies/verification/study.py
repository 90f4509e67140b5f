"""The verification study: every problem, one report."""

import math
import time
from collections.abc import Callable, Iterable
from dataclasses import asdict
from importlib import import_module
from pathlib import Path
from typing import Any

from core_models.errors import SceneError
from core_models.names import suggestion
from studies.output.output_folder import OutputFolder
from studies.output.versions import processor, versions
from studies.report.study_page import write_report
from studies.runs.record import to_json
from studies.verification.outcome import Outcome
from studies.verification.problem import Problem
from studies.verification.report import Results, report_of

PROBLEMS = {
    "patch": ("patch", "PROBLEM"),
    "rotation": ("rotation", "PROBLEM"),
    "mms-vortex": ("mms_vortex", "PROBLEM"),
    "mms-square": ("mms_axis_aligned", "SQUARE"),
    "mms-cube": ("mms_axis_aligned", "CUBE"),
    "mms-ring": ("mms_ring", "PROBLEM"),
    "vibrating-bar": ("vibrating_bar", "PROBLEM"),
    "spinning-disk": ("spinning_disk", "PROBLEM"),
    "cell-crossing": ("cell_crossing", "PROBLEM"),
    "cantilever": ("cantilever", "PROBLEM"),
    "two-disks": ("two_disks", "PROBLEM"),
    "plate-impact": ("plate_impact", "PROBLEM"),
    "sandia-spall": ("sandia_spall", "PROBLEM"),
    "friction-block": ("friction_block", "PROBLEM"),
    "cook-membrane": ("cook_membrane", "PROBLEM"),
    "taylor-elements": ("taylor_elements", "PROBLEM"),
    "taylor-quarter": ("taylor_quarter", "PROBLEM"),
    "conduction": ("conduction", "PROBLEM"),
    "speed": ("speed", "PROBLEM"),
}
"""Name of a problem: its module in `problems`, and its name there."""


LIMIT_LOADS = {
    "thick-cylinder": ("thick_cylinder", "PROBLEM"),
    "thick-sphere": ("thick_sphere", "PROBLEM"),
    "footing": ("footing", "PROBLEM"),
    "solder-lap": ("solder_lap", "PROBLEM"),
    "reversed-bar": ("reversed_bar", "PROBLEM"),
}
"""Problems of the study of limit loads, in the same form."""

NECKING_COST = {"calculix": ("beside_calculix", "PROBLEM"), "dofs": ("against_dofs", "PROBLEM")}
"""Problems of the study of what necking costs."""

STUDIES = {"verification": PROBLEMS, "limit-loads": LIMIT_LOADS, "necking-cost": NECKING_COST}
"""Problems of each study."""

_PACKAGES = {
    "verification": "studies.verification.problems",
    "limit-loads": "studies.limit_loads",
    "necking-cost": "studies.necking_cost",
}


def find_problem(name: str) -> Problem:
    """The problem of that name, in whichever study; SceneError with the nearest one otherwise."""
    for study, problems in STUDIES.items():
        if name in problems:
            module, variable = problems[name]
            return getattr(import_module(f"{_PACKAGES[study]}.{module}"), variable)
    known = [each for problems in STUDIES.values() for each in problems]
    raise SceneError(f"no verification problem is called {name!r}; {suggestion(name, known)}")


def verify(
    names: Iterable[str],
    quick: bool,
    out: Path | str,
    tell: Callable[[Problem, Outcome], None] = lambda problem, outcome: None,
    study: str = "verification",
) -> Results:
    """Run problems of a study, in the order of their names here, and write results.json, tables and reports.

    tell : called with every problem as soon as it has run. Raises SceneError, OutputError before anything is run.
    """
    problems = [find_problem(name) for name in names]
    with OutputFolder(out) as folder:
        results = []
        for problem in problems:
            outcome = timed(problem, quick)
            results.append((problem, outcome))
            tell(problem, outcome)
        folder.write_text("results.json", to_json(plain(results_entry(results, quick, study))))
        remark = write_report(report_of(results, quick, study.replace("-", " ").capitalize()), folder)
        if remark:
            results[-1][1].remarks.append(remark)
    return results


def timed(problem: Problem, quick: bool) -> Outcome:
    """The outcome of a problem, with the seconds of processor time that it took, compiling included."""
    began = time.process_time()
    outcome = problem.run(quick)
    outcome.seconds = time.process_time() - began
    return outcome


def results_entry(results: Results, quick: bool, study: str = "verification") -> dict:
    """The content of results.json."""
    return {
        "study": study,
        "quick": quick,
        "problems": [
            {
                "name": problem.name,
                "title": problem.title,
                "description": problem.description,
                "source": problem.source,
                "seconds": outcome.seconds,
                "criteria": [asdict(each) | {"met": each.met} for each in outcome.criteria],
                "tables": [asdict(each) for each in outcome.tables],
                "plots": [asdict(each) for each in outcome.plots],
                "remarks": outcome.remarks,
            }
            for problem, outcome in results
        ],
        "versions": versions(),
        "processor": processor(),
    }


def plain(content: Any) -> Any:
    """The same without infinite numbers and NaN, which JSON does not have: they become null."""
    if isinstance(content, dict):
        return {name: plain(value) for name, value in content.items()}
    if isinstance(content, list | tuple):
        return [plain(value) for value in content]
    return None if isinstance(content, float) and not math.isfinite(content) else content

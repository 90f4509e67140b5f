"""Run hard cases by variants of both methods and say which stay stable, are rescued, refused, or fail.

examples:
  matpoint study stability --quick
  matpoint study stability --cases taylor-600,erosion --methods fem-explicit,mpm,mpm:total
  matpoint study stability --cases implicit-soft,implicit-apart
  matpoint study stability --resume results/stability

Each cell runs in a process of its own with limits of time and memory. --quick makes a tenth of the steps.
Exit status: 0 when no cell has failed (a refusal by a typed error is none); 1 when some has; 2 bad input.
"""

import argparse
from pathlib import Path

from studies.options import add_json_option, names, positive
from studies.output.default_folder import default_folder

SOME_FAILED = 1


def add_options(parser: argparse.ArgumentParser) -> None:
    """Options of `matpoint study stability`."""
    parser.add_argument("--quick", action="store_true", help="a tenth of the steps")
    parser.add_argument("--cases", metavar="NAME[,NAME...]", type=names, help="these cases (default: all)")
    parser.add_argument("--methods", metavar="A[,B...]", type=names, help="variants (default: eighteen)")
    parser.add_argument(
        "--workers", metavar="N", type=positive, help="cells at a time (default: one a processor)"
    )
    folder = parser.add_mutually_exclusive_group()
    folder.add_argument(
        "--out", metavar="DIR", help="new or empty folder (default: results/stability-DATE-TIME)"
    )
    folder.add_argument("--resume", metavar="DIR", help="go on with the same study in this folder")
    add_json_option(parser)


def execute(options: argparse.Namespace) -> int:
    """Run the matrix, print it and where the report is."""
    from studies.output.study_output import print_study
    from studies.output.tally import Tally
    from studies.stability.cases import all_cases, find_case
    from studies.stability.study import VARIANTS, pairs, survey_stability
    from studies.stability.tables import summary, without_laws

    out = Path(options.resume or options.out or default_folder("stability"))
    cases = [find_case(name) for name in options.cases or all_cases()]
    tally = Tally(len(pairs(cases, options.methods or VARIANTS)))
    outcome = survey_stability(
        out,
        quick=options.quick,
        cases=options.cases,
        variants=options.methods,
        workers=options.workers,
        going_on=options.resume is not None,
        tell=lambda cell: tally.tell(without_laws(_said(cell))),
    )
    print_study(out, summary(outcome.cells), outcome.remark, as_json=options.json)
    return SOME_FAILED if outcome.failed else 0


def _said(cell: dict) -> str:
    said = f": {cell['why']}" if cell["why"] else ""
    return f"{cell['case']}, {cell['variant']}: {cell['verdict']}{said}"

"""Run problems with known answers by both methods and say which criteria are met.

examples:
  matpoint study verification --quick
  matpoint study verification --only mms-vortex,plate-impact --out results/verification

It writes results.json and report.html. The full study takes about half an hour on
one core, --quick several minutes.
Exit status: 0 when every criterion is met; 1 when some is not; 2 bad input.
"""

import argparse
from pathlib import Path

from studies.default_folder import default_folder
from studies.options import names

UNMET = 1


def add_options(parser: argparse.ArgumentParser) -> None:
    """Options of `matpoint study verification`."""
    add_problem_options(parser)


def execute(options: argparse.Namespace) -> int:
    """Run the problems one after the other, print their verdicts and where the report is."""
    return run_problems(options, "verification")


def add_problem_options(parser: argparse.ArgumentParser) -> None:
    """Options of a study that consists of problems."""
    parser.add_argument("--only", metavar="NAME[,NAME...]", type=names, help="these problems (default: all)")
    parser.add_argument("--quick", action="store_true", help="coarser and fewer runs, the same criteria")
    parser.add_argument(
        "--out", metavar="DIR", help="new or empty folder for the results (default: results/STUDY-DATE-TIME)"
    )


def run_problems(options: argparse.Namespace, study: str) -> int:
    """Run the problems of a study one after the other, print their verdicts and where the report is."""
    from studies.verification.study import STUDIES, verify
    from studies.verification.text import outcome_text

    out = Path(options.out or default_folder(study))
    results = verify(
        options.only or tuple(STUDIES[study]),
        options.quick,
        out,
        tell=lambda problem, outcome: print(outcome_text(problem, outcome), flush=True),
        study=study,
    )
    page = out / "report.html"
    print(page if page.exists() else out / "results.json")
    return 0 if all(criterion.met for _, outcome in results for criterion in outcome.criteria) else UNMET

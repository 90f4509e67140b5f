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

from studies.options import add_json_option, names
from studies.output.default_folder import default_folder

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
    add_json_option(parser)


def run_problems(options: argparse.Namespace, study: str) -> int:
    """Run the problems of a study one after the other, print their verdicts and where the report is."""
    from studies.output.study_output import print_study
    from studies.output.tally import Tally
    from studies.verification.study import STUDIES, verify
    from studies.verification.text import outcome_text

    out = Path(options.out or default_folder(study))
    asked = options.only or tuple(STUDIES[study])
    tally, told = Tally(len(asked)), []

    def tell(problem, outcome) -> None:
        told.append(outcome_text(problem, outcome))
        tally.tell(told[-1].splitlines()[0])

    results = verify(asked, options.quick, out, tell=tell, study=study)
    remark = "" if (out / "report.html").exists() else results[-1][1].remarks[-1]
    print_study(out, "\n".join(told), remark, as_json=options.json)
    return 0 if all(criterion.met for _, outcome in results for criterion in outcome.criteria) else UNMET

"""Compare 85 Taylor shots of copper, aluminium and steel with what flow laws and both methods predict.

examples:
  matpoint study experiments --quick
  matpoint study experiments --out results/shots
  matpoint study experiments --resume results/shots
  matpoint study experiments --scheduler tcp://10.0.0.1:8786

The runs go to a Dask cluster of this machine (extra 'sweep'; without it to plain processes), or to the scheduler at an
address. A run that goes wrong is listed and stops nothing. --quick takes one card for each metal, coarsely.
Exit status: 0; 2 bad input; 3 when some run went wrong.
"""

import argparse
import logging
import sys
import time
from pathlib import Path

from studies.options import add_json_option, positive
from studies.output.clock import clock
from studies.output.default_folder import default_folder

WRONG = 3
logger = logging.getLogger(__name__)


def add_options(parser: argparse.ArgumentParser) -> None:
    """Options of `matpoint study experiments`."""
    parser.add_argument("--quick", action="store_true", help="coarser runs, one card for each metal")
    where = parser.add_mutually_exclusive_group()
    where.add_argument(
        "--scheduler",
        metavar="ADDRESS",
        help="a running Dask scheduler, like tcp://host:8786, whose workers are its own",
    )
    where.add_argument(
        "--workers", metavar="N", type=positive, help="processes on this machine (default: one a processor)"
    )
    add_json_option(parser)
    folder = parser.add_mutually_exclusive_group()
    folder.add_argument(
        "--out", metavar="DIR", help="new or empty folder (default: results/experiments-DATE-TIME)"
    )
    folder.add_argument("--resume", metavar="DIR", help="go on with the study in this folder")


def execute(options: argparse.Namespace) -> int:
    """Run what is not done yet, print the medians and where the report is."""
    from studies.experiments.study import compare_experiments
    from studies.output.study_output import print_study
    from studies.report.study_text import table_text

    out = Path(options.resume or options.out or default_folder("experiments"))
    began = time.monotonic()
    outcome = compare_experiments(
        out,
        quick=options.quick,
        going_on=options.resume is not None,
        scheduler=options.scheduler,
        workers=options.workers,
        tell=lambda result, done, all_: _tell(result, done, all_, time.monotonic() - began),
    )
    text = "\n\n".join(table_text(each.tables[0]) for each in outcome.report.sections[:2])
    print_study(out, text, outcome.remark, as_json=options.json)
    return WRONG if outcome.failed else 0


def _tell(result: dict, done: int, all_: int, passed: float) -> None:
    """One line a run, and its remarks as warnings of this process; numerical fracture is told by that line."""
    from studies.observers.fracture_watch import fracture_text

    parted = result.get("numerical_fracture")
    fracture = "" if parted is None else fracture_text(parted)
    for remark in result.get("remarks", ()):
        if remark != fracture:
            logger.warning("%s", remark)
    said = fracture.partition(":")[0] if result["status"] == "complete" else result["message"][:120]
    said = f": {said}" if said else ""
    left = clock(passed / done * (all_ - done))
    print(
        f"[{done}/{all_}, {left} left] {result['key']} {result['status']}{said}", file=sys.stderr, flush=True
    )

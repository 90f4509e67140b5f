"""Pull a bar or strip until it necks, by finite elements and the material point method, implicit and explicit.

examples:
  matpoint study necking
  matpoint study necking necking-weldox-damage --methods fem-implicit,mpm-implicit
  matpoint study necking --quick --out results/necking
  matpoint study necking --resume results/necking

SCENE is necking-simo (if left out), necking-jc-42crmo4, necking-weldox-damage, necking-gtn, necking-plane-strain, or an
XML file. It writes results.json, runs/*.json and report.html with all curves over each other. Runs go to one process a
processor; one that goes wrong stops nothing. With --resume a run that was made is not made again, and one that was
stopped goes on from its last state, an implicit one also with increments and tolerance that were edited in the scene.
Exit status: 0 when every criterion is met; 1 when some is not; 2 bad input; 3 when a run has stopped on its way, whose
curves up to there are kept.
"""

import argparse
import sys
import time
from pathlib import Path

from studies.options import add_json_option, names, positive
from studies.output.clock import clock
from studies.output.default_folder import default_folder

UNMET = 1


def add_options(parser: argparse.ArgumentParser) -> None:
    """Options of `matpoint study necking`."""
    parser.add_argument("scene", metavar="SCENE", nargs="?", default="necking-simo", help="its name or file")
    parser.add_argument(
        "--methods",
        metavar="A[,B...]",
        type=names,
        help="methods or single runs (default: all but extra ones)",
    )
    parser.add_argument("--quick", action="store_true", help="the scene's quick runs only")
    parser.add_argument("--workers", metavar="N", type=positive, help="processes (default: one a processor)")
    add_json_option(parser)
    folder = parser.add_mutually_exclusive_group()
    folder.add_argument("--out", metavar="DIR", help="new or empty folder (default: results/SCENE-DATE-TIME)")
    folder.add_argument("--resume", metavar="DIR", help="go on with the study in this folder")


def execute(options: argparse.Namespace) -> int:
    """Make the runs that are not made yet, print the verdicts and where the report is."""
    from studies.necking.study import study_necking
    from studies.output.study_output import print_study
    from studies.verification.text import criterion_text

    out = Path(options.resume or options.out or default_folder(Path(options.scene).stem))
    began, statuses = time.monotonic(), [0]

    def tell(result: dict, done: int, all_: int) -> None:
        statuses.append(result.get("exit_status", 0))
        _tell(result, done, all_, time.monotonic() - began)

    outcome = study_necking(
        options.scene,
        out,
        methods=options.methods,
        quick=options.quick,
        going_on=options.resume is not None,
        workers=options.workers,
        tell=tell,
    )
    met = sum(criterion.met for criterion in outcome.criteria)
    told = [
        f"{options.scene}: {met} of {len(outcome.criteria)} criteria met, {outcome.seconds:.0f} s of processor time",
        *(f"  {'met' if each.met else 'not met'}: {criterion_text(each)}" for each in outcome.criteria),
    ]
    remark = "" if (out / "report.html").exists() else outcome.remarks[-1]
    print_study(out, "\n".join(told), remark, as_json=options.json)
    return max(statuses) or (0 if met == len(outcome.criteria) else UNMET)


def _tell(result: dict, done: int, all_: int, passed: float) -> None:
    said = result["message"][:120] or f"{result['seconds']:.1f} s"
    left = clock(passed / done * (all_ - done))
    print(f"[{done}/{all_}, {left} left] {result['key']}: {said}", file=sys.stderr, flush=True)

"""Say how long each variant of both methods takes to reach an error of 5, 2, 1, 0.5 and 0.1 %.

examples:
  matpoint study work-precision taylor-classic --wall plane
  matpoint study work-precision vibrating-bar --methods fem-explicit,mpm,mpm:total
  matpoint study work-precision my_scene.xml --resolutions 4,6,8,12,16 --repeats 5

SCENE is vibrating-bar or vortex, which have exact answers, a shipped scene, or a scene's file. Every variant is run at
five or more resolutions on one thread, one run at a time, compiled beforehand, and its finest once more on all threads.
What a scene gives no published value for is held against the joint extrapolation of all runs. --resume goes on with the
same study where it was stopped.
Exit status: 0; 2 bad input; 3 when no run came to an end.
"""

import argparse
import sys
from pathlib import Path

from studies.default_folder import default_folder
from studies.options import names, positive, whole_numbers

NOTHING = 3


def add_options(parser: argparse.ArgumentParser) -> None:
    """Options of `matpoint study work-precision`."""
    parser.add_argument(
        "scene", metavar="SCENE", help="vibrating-bar, vortex, a shipped scene or an XML file"
    )
    parser.add_argument("--methods", metavar="A[,B...]", type=names, help="variants (default: the problem's)")
    parser.add_argument(
        "--resolutions", metavar="N,N,...", type=whole_numbers, help="five or more (default: the problem's)"
    )
    parser.add_argument("--wall", metavar="NAME", help="unilateral or plane (default: the scene's)")
    parser.add_argument("--repeats", metavar="N", type=positive, default=3, help="of each run (default: 3)")
    parser.add_argument(
        "--threads", metavar="N", type=positive, help="of each variant's finest run once more (default: all)"
    )
    folder = parser.add_mutually_exclusive_group()
    folder.add_argument(
        "--out", metavar="DIR", help="new or empty folder (default: results/work-precision-DATE-TIME)"
    )
    folder.add_argument("--resume", metavar="DIR", help="go on with the same study in this folder")


def execute(options: argparse.Namespace) -> int:
    """Measure, print the tables of times and where the report is."""
    from core_models.walls import check_wall
    from studies.report.study_text import table_text
    from studies.work_precision.study import compare_work, find_problem

    wall = None if options.wall is None else check_wall(options.wall)
    problem = find_problem(options.scene, wall)
    out = Path(options.resume or options.out or default_folder("work-precision"))
    outcome = compare_work(
        problem,
        out,
        variants=options.methods,
        resolutions=options.resolutions,
        repeats=options.repeats,
        threads=options.threads,
        going_on=options.resume is not None,
        tell=_tell,
    )
    for section in outcome.report.sections:
        if section.name.startswith("reach-"):
            print(f"{section.title}\n{table_text(section.tables[0])}\n")
        if section.name == "verdict":
            print("".join(f"{sentence}\n" for sentence in section.remarks))
    if outcome.remark:
        print(f"matpoint: {outcome.remark}", file=sys.stderr)
    print(out / ("report.md" if outcome.remark else "report.html"))
    return 0 if any(run.values for run in outcome.runs) else NOTHING


def _tell(run) -> None:
    said = f"{run.seconds:.2f} s" if run.values else run.message[:120]
    on = f" on {run.threads} threads" if run.threads > 1 else ""
    print(f"{run.variant} {run.resolution}{on}: {said}", file=sys.stderr, flush=True)

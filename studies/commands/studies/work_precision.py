"""Say how long each variant of both methods takes to reach an error of 5, 2, 1, 0.5 and 0.1 %.

examples:
  matpoint study work-precision taylor-classic --wall plane
  matpoint study work-precision vibrating-bar --methods fem-explicit,mpm,mpm:total
  matpoint study work-precision necking-simo --methods fem-implicit,mpm-implicit
  matpoint study work-precision my_scene.xml --resolutions 4,6,8,12,16 --repeats 5

SCENE is vibrating-bar or vortex, which have exact answers, necking-simo, a shipped scene of impact, or a scene's file.
Every variant is run at five or more resolutions on one thread, one run at a time, compiled beforehand, and its finest
once more on all threads. What a scene gives no published value for is held against the joint extrapolation of all runs.
--resume goes on with the same study where it was stopped.
Exit status: 0; 2 bad input; 3 when no run came to an end.
"""

import argparse
from collections.abc import Iterator
from pathlib import Path

from studies.options import add_json_option, names, positive, whole_numbers
from studies.output.default_folder import default_folder

NOTHING = 3


def add_options(parser: argparse.ArgumentParser) -> None:
    """Options of `matpoint study work-precision`."""
    parser.add_argument(
        "scene", metavar="SCENE", help="vibrating-bar, vortex, necking-simo, a shipped scene or an XML file"
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
    add_json_option(parser)


def execute(options: argparse.Namespace) -> int:
    """Measure, print the tables of times and where the report is."""
    from core_models.walls import check_wall
    from studies.output.study_output import print_study
    from studies.output.tally import Tally
    from studies.work_precision.study import compare_work, find_problem, planned

    wall = None if options.wall is None else check_wall(options.wall)
    problem = find_problem(options.scene, wall)
    out = Path(options.resume or options.out or default_folder("work-precision"))
    plan = planned(problem, options.methods, options.resolutions)
    shared = 0 if options.threads == 1 else len({variant for variant, _ in plan})
    tally = Tally(len(plan) + shared)
    outcome = compare_work(
        problem,
        out,
        variants=options.methods,
        resolutions=options.resolutions,
        repeats=options.repeats,
        threads=options.threads,
        going_on=options.resume is not None,
        tell=lambda run: tally.tell(_said(run)),
    )
    print_study(out, "\n\n".join(_texts(outcome)), outcome.remark, as_json=options.json)
    return 0 if any(run.values for run in outcome.runs) else NOTHING


def _texts(outcome) -> Iterator[str]:
    from studies.report.study_text import table_text

    for section in outcome.report.sections:
        if section.name == "choice":
            yield "\n".join([section.title, *(each.text for each in section.verdicts)])
        if section.name.startswith("reach-"):
            yield f"{section.title}\n{table_text(section.tables[0])}"
        if section.name == "verdict":
            yield "\n".join(section.remarks)


def _said(run) -> str:
    said = f"{run.seconds:.2f} s" if run.values else run.message
    on = f" on {run.threads} threads" if run.threads > 1 else ""
    return f"{run.variant} {run.resolution}{on}: {said}"

"""Switch each effect of a scene and say what it costs in time and memory and what it changes in the answers.

examples:
  matpoint study effects taylor-copper-jc
  matpoint study effects taylor-ofhc-190 --methods mpm --resolution 6

Damage, heating, conduction, the equation of state against a linear one, bulk viscosity, friction, and three dimensions
against axial symmetry, next to what the scene's own numbers say beforehand.
Exit status: 0; 2 bad input; 3 when no run came to an end.
"""

import argparse
from pathlib import Path

from studies.options import add_json_option, add_scene_options, asked_scene, names, positive
from studies.output.default_folder import default_folder

NOTHING = 3


def add_options(parser: argparse.ArgumentParser) -> None:
    """Options of `matpoint study effects`."""
    add_scene_options(parser)
    parser.add_argument("--methods", metavar="A[,B...]", type=names, help="default: fem-explicit,mpm")
    parser.add_argument(
        "--resolution", metavar="N", type=positive, default=8, help="across the radius (default: 8)"
    )
    parser.add_argument("--wall", metavar="NAME", help="unilateral or plane (default: the scene's)")
    parser.add_argument("--repeats", metavar="N", type=positive, default=3, help="of each run (default: 3)")
    parser.add_argument("--planar", action="store_true", help="leave the run in three dimensions out")
    parser.add_argument(
        "--out", metavar="DIR", help="new or empty folder (default: results/effects-DATE-TIME)"
    )
    add_json_option(parser)


def execute(options: argparse.Namespace) -> int:
    """Print the decisions, measure, print the changes and where the report is."""
    scene = asked_scene(options)
    from studies.effects_study.study import compare_effects, planned
    from studies.output.study_output import print_study
    from studies.output.tally import Tally
    from studies.report.study_text import table_text

    out = Path(options.out or default_folder(f"effects-{scene.name}"))
    methods = options.methods or ("fem-explicit", "mpm")
    tally = Tally(sum(len(planned(scene, method, not options.planar)) for method in methods))
    outcome = compare_effects(
        scene,
        out,
        methods=methods,
        resolution=options.resolution,
        wall=options.wall,
        repeats=options.repeats,
        spatial=not options.planar,
        tell=lambda switched: tally.tell(_said(switched)),
    )
    tables = [section.tables[0] for section in outcome.report.sections if section.tables]
    text = "\n\n".join(table_text(each) for each in tables if each.rows)
    print_study(out, text, outcome.remark, as_json=options.json)
    return 0 if any(each.run.values for each in outcome.runs) else NOTHING


def _said(switched) -> str:
    said = f"{switched.run.seconds:.2f} s" if switched.run.values else switched.run.message
    return f"{switched.method}: {switched.effect} {switched.to} {said}"

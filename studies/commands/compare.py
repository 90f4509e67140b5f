"""Run a scene by several methods at several resolutions and compare them.

examples:
  matpoint compare taylor-copper-jc
  matpoint compare taylor-classic --wall plane --resolution 8,12,16 --out results/classic
  matpoint compare taylor-ofhc-190 --methods mpm --threads 2
  matpoint compare taylor-copper-jc --resume results/copper
  matpoint compare taylor-classic --resolution 8 --json > classic.json

Prints a table and writes results.json, report.html, report.md, tables as CSV and one folder per run.
Exit status: 0; 2 bad input; 3 a run went wrong (the others are still compared).
"""

import argparse
import sys
from pathlib import Path

from core_models.errors import RunFailure, SceneError
from studies.options import add_json_option, add_method_options, add_scene_options, asked_scene
from studies.output.default_folder import default_folder


def add_options(parser: argparse.ArgumentParser) -> None:
    """Options of `matpoint compare`."""
    add_scene_options(parser)
    add_method_options(parser)
    parser.add_argument(
        "--resume", metavar="DIR", help="go on with the same comparison in this folder, which was stopped"
    )
    add_json_option(parser)


def execute(options: argparse.Namespace) -> int:
    """Compare, print the table and where the report is."""
    scene = asked_scene(options)
    from studies.comparisons.comparing import compare
    from studies.methods.method import METHODS
    from studies.observers.progress import can_show
    from studies.output.text_table import comparison_text

    if options.resume and options.out:
        raise SceneError("--resume goes on in the folder it names: leave --out away")
    out = Path(options.resume or options.out or default_folder(scene.name))
    comparison = compare(
        scene,
        options.methods or tuple(METHODS),
        options.resolution,
        wall=options.wall,
        threads=options.threads,
        out=out,
        going_on=options.resume is not None,
        progress=can_show(sys.stderr),
    )
    if comparison.notice:
        print(f"matpoint: {comparison.notice}", file=sys.stderr)
    if options.json:
        from studies.output.json_output import print_results

        print_results(out)
        return RunFailure.exit_status if comparison.failed else 0
    page = out / "report.html"
    print(f"{comparison_text(comparison)}\n\n{page if page.exists() else out / 'results.json'}")
    return RunFailure.exit_status if comparison.failed else 0

"""Run a scene by one method at one resolution and keep the run in a folder.

examples:
  matpoint run taylor-classic --method fem-explicit --resolution 8 --wall plane
  matpoint run my_scene.xml --method mpm --out results/mine --search-root cards
  matpoint run taylor-classic --resolution 100 --checkpoint-every 10min --out results/fine
  matpoint run --resume results/fine

The folder holds scene.xml, history.csv, frames/*.vtu with series.pvd (ParaView) and, last, run.json.
Exit status: 0; 2 bad input; 3 the run went wrong.
"""

import argparse
import sys

from core_models.errors import SceneError
from studies.options import add_json_option, add_method_options, add_scene_options, asked_scene
from studies.output.default_folder import default_folder


def add_options(parser: argparse.ArgumentParser) -> None:
    """Options of `matpoint run`."""
    add_scene_options(parser, optional=True)
    add_method_options(parser)
    parser.add_argument(
        "--checkpoint-every",
        metavar="T",
        help="60s, 10min, 2h or 500steps: what a kill can cost (default: 60s where the method can)",
    )
    parser.add_argument(
        "--resume", metavar="DIR", help="go on with the run in this folder from its last checkpoint"
    )
    add_json_option(parser)


def execute(options: argparse.Namespace) -> int:
    """Run, or go on with a run, and print."""
    if options.resume is not None:
        return _resume(options)
    if options.scene is None:
        raise SceneError("name a scene (matpoint scenes lists those shipped), or a run with --resume DIR")
    scene = asked_scene(options)
    method, resolution = _one(options.methods, "method"), _one(options.resolution, "resolution")
    from studies.checkpointing.interval import read_interval
    from studies.observers.progress import can_show
    from studies.runs.running import run

    every = options.checkpoint_every
    out = options.out or default_folder(scene.name)
    result = run(
        scene,
        method or "fem-explicit",
        resolution,
        wall=options.wall,
        threads=options.threads,
        out=out,
        progress=can_show(sys.stderr),
        interval=None if every is None else read_interval(every),
    )
    _print(result, out, options.json)
    return 0


def _print(result, folder: str, as_json: bool) -> None:
    if as_json:
        from studies.output.json_output import json_text
        from studies.runs.record import run_record

        print(json_text({"folder": folder} | run_record(result)))
        return
    from studies.runs.text import run_text

    print(f"{run_text(result)}\n\n{folder}")


def _resume(options: argparse.Namespace) -> int:
    given = (options.scene, options.methods, options.resolution, options.wall, options.out)
    if any(option is not None for option in given):
        raise SceneError(
            "--resume goes on with a run as it was started: leave scene, method, resolution, wall and --out away"
        )
    from studies.checkpointing.interval import read_interval
    from studies.checkpointing.resuming import resume
    from studies.observers.progress import can_show

    every = options.checkpoint_every
    result = resume(
        options.resume,
        interval=None if every is None else read_interval(every),
        progress=can_show(sys.stderr),
    )
    _print(result, options.resume, options.json)
    return 0


def _one(given: tuple | None, what: str):
    if given is not None and len(given) > 1:
        raise SceneError(f"matpoint run takes one {what}, not {len(given)}; use matpoint compare for several")
    return given[0] if given else None

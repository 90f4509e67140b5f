"""Run a scene by one method at one resolution and keep the run in a folder.

examples:
  matpoint run taylor-classic --method fem-explicit --resolution 8 --wall plane
  matpoint run my_scene.xml --method mpm --out results/mine --search-root cards

The folder holds scene.xml, history.csv, frames/*.vtu with series.pvd (ParaView) and, last, run.json.
Exit status: 0; 2 bad input; 3 the run went wrong.
"""

import argparse
import sys

from core_models.errors import SceneError
from studies.default_folder import default_folder
from studies.options import add_method_options, add_scene_options, asked_scene


def add_options(parser: argparse.ArgumentParser) -> None:
    """Options of `matpoint run`."""
    add_scene_options(parser)
    add_method_options(parser)


def execute(options: argparse.Namespace) -> int:
    """Run and print."""
    scene = asked_scene(options)
    method, resolution = _one(options.methods, "method"), _one(options.resolution, "resolution")
    from studies.progress import can_show
    from studies.run_text import run_text
    from studies.running import run

    out = options.out or default_folder(scene.name)
    result = run(
        scene,
        method or "fem-explicit",
        resolution,
        wall=options.wall,
        threads=options.threads,
        out=out,
        progress=can_show(sys.stderr),
    )
    print(f"{run_text(result)}\n\n{out}")
    return 0


def _one(given: tuple | None, what: str):
    if given is not None and len(given) > 1:
        raise SceneError(f"matpoint run takes one {what}, not {len(given)}; use matpoint compare for several")
    return given[0] if given else None

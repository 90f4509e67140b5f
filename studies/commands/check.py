"""Read a scene and everything it needs, and say what would be simulated; nothing is run or written.

examples:
  matpoint check taylor-copper-mts
  matpoint check my_scene.xml --resolution 8 --method mpm

Exit status: 0; 2 bad input.
"""

import argparse

from studies.options import add_json_option, add_method_options, add_scene_options, asked_scene


def add_options(parser: argparse.ArgumentParser) -> None:
    """Options of `matpoint check`."""
    add_scene_options(parser)
    add_method_options(parser)
    add_json_option(parser)


def execute(options: argparse.Namespace) -> int:
    """Print the plan."""
    scene = asked_scene(options)
    from core_models.walls import check_wall
    from studies.methods.method import METHODS, check_solver, planned_runs
    from studies.output.json_output import json_text
    from studies.output.output_folder import check_unused
    from studies.scenes.plan import plan_record
    from studies.scenes.plan_text import plan_text

    if options.out is not None:
        check_unused(options.out)
    wall = check_wall(options.wall or scene.wall)
    coarsest: dict[str, int] = {}
    for method, resolution in planned_runs(scene, options.methods or tuple(METHODS), options.resolution):
        coarsest.setdefault(method, resolution)
    for method, resolution in coarsest.items():
        check_solver(scene, method, resolution, wall, options.threads)
    asked = (scene, options.methods, options.resolution, options.wall)
    print(json_text(plan_record(*asked)) if options.json else plan_text(*asked))
    return 0

"""Read a scene and everything it needs, and say what would be simulated; nothing is run or written.

examples:
  matpoint check taylor-copper-mts
  matpoint check my_scene.xml --resolution 8 --method mpm

Exit status: 0; 2 bad input.
"""

import argparse

from studies.options import add_method_options, add_scene_options, asked_scene


def add_options(parser: argparse.ArgumentParser) -> None:
    """Options of `matpoint check`."""
    add_scene_options(parser)
    add_method_options(parser)


def execute(options: argparse.Namespace) -> int:
    """Print the plan."""
    scene = asked_scene(options)
    from studies.output_folder import check_unused
    from studies.plan_text import plan_text

    if options.out is not None:
        check_unused(options.out)
    print(plan_text(scene, options.methods, options.resolution, options.wall))
    return 0

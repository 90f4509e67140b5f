"""List the shipped scenes.

example:
  matpoint scenes
"""

import argparse

from studies.shipped_scenes import shipped_scenes


def add_options(parser: argparse.ArgumentParser) -> None:
    """`matpoint scenes` has no options."""


def execute(options: argparse.Namespace) -> int:
    """Print name and description of every shipped scene."""
    from studies.scene_reader import read_scene

    for name in shipped_scenes():
        scene = read_scene(name)
        print(f"{name}\n    {scene.description}")
        print(
            f"    L0 {scene.bar.length * 1e3:g} mm, R0 {scene.bar.radius * 1e3:g} mm, "
            f"{-scene.bar.velocity:g} m/s, wall {scene.wall}"
        )
    return 0

"""List the shipped scenes.

examples:
  matpoint scenes
  matpoint scenes --json

Exit status: 0; 2 bad input.
"""

import argparse
import logging

from studies.options import add_json_option
from studies.scenes.shipped import shipped_scenes


def add_options(parser: argparse.ArgumentParser) -> None:
    """Options of `matpoint scenes`."""
    add_json_option(parser)


def execute(options: argparse.Namespace) -> int:
    """Print name, description, size, speed and wall of every shipped scene."""
    from studies.output.json_output import json_text
    from studies.scenes.reader import read_scene

    # What their materials are warned about is said where they are checked or run.
    logging.disable(logging.WARNING)
    try:
        scenes = [read_scene(name) for name in shipped_scenes()]
    finally:
        logging.disable(logging.NOTSET)
    if options.json:
        print(json_text([_record(scene) for scene in scenes]))
        return 0
    for scene in scenes:
        print(f"{scene.name}\n    {scene.description}")
        print(
            f"    L0 {scene.bar.length * 1e3:g} mm, R0 {scene.bar.radius * 1e3:g} mm, "
            f"{-scene.bar.velocity:g} m/s, wall {scene.wall}"
        )
    return 0


def _record(scene) -> dict:
    return {
        "name": scene.name,
        "description": scene.description,
        "length": scene.bar.length,
        "radius": scene.bar.radius,
        "velocity": scene.bar.velocity,
        "temperature": scene.bar.temperature,
        "wall": scene.wall,
    }

"""List the material laws by slot, or explain one: equation, parameters, units, ranges, source, card tags.

examples:
  matpoint models
  matpoint models johnson_cook
  matpoint models MechanicalThreshold
"""

import argparse


def add_options(parser: argparse.ArgumentParser) -> None:
    """Options of `matpoint models`."""
    parser.add_argument("name", metavar="NAME", nargs="?", help="a law's class name or its type in a card")


def execute(options: argparse.Namespace) -> int:
    """Print the list or one law."""
    from studies.model_text import model_list, model_text

    print(model_list() if options.name is None else model_text(options.name))
    return 0

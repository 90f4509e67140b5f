"""List the material laws by slot, or explain one: equation, parameters, units, ranges, source, card tags.

examples:
  matpoint models
  matpoint models johnson_cook
  matpoint models ptw
  matpoint models ludwik --laws my_laws.py
  matpoint models --compatibility
  matpoint models --json

Exit status: 0; 2 bad input.
"""

import argparse

from studies.options import add_json_option


def add_options(parser: argparse.ArgumentParser) -> None:
    """Options of `matpoint models`."""
    about = "a law's class name, its type in a card, its initials (ptw) or a part of its name (drucker)"
    parser.add_argument("name", metavar="NAME", nargs="?", help=about)
    parser.add_argument("--compatibility", action="store_true", help="which laws fit together, and why not")
    parser.add_argument("--laws", metavar="FILE", help="Python file with laws of your own")
    add_json_option(parser)


def execute(options: argparse.Namespace) -> int:
    """Print the list, one law or the table of what fits together."""
    from core_models import user_laws
    from studies.laws.compatibility_text import compatibility_text
    from studies.laws.model_record import compatibility_record, model_records
    from studies.laws.model_text import model_list, model_text
    from studies.output.json_output import json_text

    if options.laws is not None:
        user_laws.load(options.laws)
    if options.json:
        print(json_text(compatibility_record() if options.compatibility else model_records(options.name)))
    elif options.compatibility:
        print(compatibility_text())
    else:
        print(model_list() if options.name is None else model_text(options.name))
    return 0

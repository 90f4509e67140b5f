"""Run a study and write its report.

examples:
  matpoint study verification --quick
  matpoint study experiments --quick --out results/shots
  matpoint study work-precision taylor-classic --wall plane

Each study has its own options: matpoint study experiments --help
"""

import argparse
from importlib import import_module

from core_models.errors import SceneError
from core_models.names import suggestion
from studies.options import Parser

STUDIES = {
    "verification": "problems with known answers, by both methods",
    "necking": "bars and strips pulled until they neck, by five methods",
    "necking-cost": "implicit necking: time against degrees of freedom, and beside CalculiX",
    "limit-loads": "slow loads until a body flows, against closed forms, by three methods",
    "experiments": "85 Taylor shots against flow laws and methods",
    "stability": "hard cases: stable, rescued, refused or failed",
    "effects": "what each effect of a scene costs and changes",
    "work-precision": "time of every variant to reach an error of 5 to 0.1 %",
}
"""Name of a study: what it does. Its module in `studies.commands.studies` has its options and prints."""


class _Studies(argparse._SubParsersAction):
    """The studies as sub-commands; an unknown one is answered with the nearest."""

    def __call__(self, parser, namespace, values, option_string=None) -> None:
        if values[0] not in STUDIES:
            raise SceneError(f"no study is called {values[0]!r}; {suggestion(values[0], STUDIES)}")
        super().__call__(parser, namespace, values, option_string)


def add_options(parser: argparse.ArgumentParser) -> None:
    """The studies, each with the options of its own."""
    studies = parser.add_subparsers(
        title="studies", metavar="STUDY", required=True, action=_Studies, parser_class=Parser
    )
    for name, summary in STUDIES.items():
        module = import_module(f"studies.commands.studies.{name.replace('-', '_')}")
        own = studies.add_parser(
            name, help=summary.replace("%", "%%"), formatter_class=argparse.RawDescriptionHelpFormatter
        )
        own.description, own.epilog = module.__doc__.split("\n\n", 1)
        module.add_options(own)
        own.set_defaults(execute_study=module.execute, known_options=own.option_names)


def execute(options: argparse.Namespace) -> int:
    """Run the study that was asked for."""
    return options.execute_study(options)

"""Pull a bar until it necks, by implicit and explicit finite elements and the material point method.

examples:
  matpoint study necking
  matpoint study necking --quick --out results/necking

It writes results.json and report.html, with the curves of two other codes. The full study takes about 5 minutes on one
core, --quick, implicit elements only, a quarter of a minute.
Exit status: 0 when every criterion is met; 1 when some is not; 2 bad input.
"""

import argparse

from studies.commands.studies.verification import add_problem_options, run_problems


def add_options(parser: argparse.ArgumentParser) -> None:
    """Options of `matpoint study necking`."""
    add_problem_options(parser)


def execute(options: argparse.Namespace) -> int:
    """Run the problems one after the other, print their verdicts and where the report is."""
    return run_problems(options, "necking")

"""Say what implicit necking costs: time against degrees of freedom, and beside CalculiX where it is installed.

examples:
  matpoint study necking-cost
  matpoint study necking-cost --only dofs --quick --out results/necking-cost

Problems: calculix (2 minutes) and dofs (5 minutes). It writes results.json and report.html.
Exit status: 0 when every criterion is met; 1 when some is not; 2 bad input.
"""

import argparse

from studies.commands.studies.verification import add_problem_options, run_problems


def add_options(parser: argparse.ArgumentParser) -> None:
    """Options of `matpoint study necking-cost`."""
    add_problem_options(parser)


def execute(options: argparse.Namespace) -> int:
    """Run the problems one after the other, print their verdicts and where the report is."""
    return run_problems(options, "necking-cost")

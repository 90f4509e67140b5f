"""Load small bodies slowly until they flow, by implicit and explicit elements and by material points.

examples:
  matpoint study limit-loads
  matpoint study limit-loads --quick --only footing --out results/footing

Thick cylinder and sphere, footing, soldered lap joint, bar under reversed strain, against closed forms. It writes
results.json and report.html.
Exit status: 0 when every criterion is met; 1 when some is not; 2 bad input.
"""

import argparse

from studies.commands.studies.verification import add_problem_options, run_problems


def add_options(parser: argparse.ArgumentParser) -> None:
    """Options of `matpoint study limit-loads`."""
    add_problem_options(parser)


def execute(options: argparse.Namespace) -> int:
    """Run the problems one after the other, print their verdicts and where the report is."""
    return run_problems(options, "limit-loads")

"""Measure the speed of this machine: point updates of every flow law and whole steps, warm, the median of some repeats.

The first time it compiles for some minutes.

example:
  matpoint bench
  matpoint bench --threads 2
  matpoint bench --json > speed.json

Exit status: 0; 2 bad input.
"""

import argparse

from studies.options import add_json_option, positive


def add_options(parser: argparse.ArgumentParser) -> None:
    """Options of `matpoint bench`."""
    parser.add_argument("--threads", metavar="K", type=positive, default=1, help="threads (default: 1)")
    parser.add_argument(
        "--points", metavar="N", type=positive, default=100_000, help="points of the point updates"
    )
    add_json_option(parser)


def execute(options: argparse.Namespace) -> int:
    """Print the speed table."""
    from studies.bench.speeds import bench_record, bench_text
    from studies.output.json_output import json_text

    asked = (options.points, options.threads)
    print(json_text(bench_record(*asked)) if options.json else bench_text(*asked))
    return 0

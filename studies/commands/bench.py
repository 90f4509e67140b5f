"""Measure the speed of this machine: point updates of every flow law and whole steps, warm, the median of some repeats.

The first time it compiles for some minutes.

example:
  matpoint bench
  matpoint bench --threads 2
"""

import argparse

from studies.options import positive


def add_options(parser: argparse.ArgumentParser) -> None:
    """Options of `matpoint bench`."""
    parser.add_argument("--threads", metavar="K", type=positive, default=1, help="threads (default: 1)")
    parser.add_argument(
        "--points", metavar="N", type=positive, default=100_000, help="points of the point updates"
    )


def execute(options: argparse.Namespace) -> int:
    """Print the speed table."""
    from studies.bench import bench_text

    print(bench_text(options.points, options.threads))
    return 0

"""The command `matpoint`: one small module per verb, imported only when it is used."""

import argparse
import errno
import sys
from collections.abc import Sequence
from importlib import import_module

from studies.options import Parser
from studies.output.told_once import tell_warnings_once
from studies.own_packages import check_own_packages
from studies.process import discard_output, interruptible, tolerate_any_text

VERBS = {
    "run": "run a scene by one method",
    "compare": "run a scene by several methods and resolutions and write a report",
    "check": "read a scene, say what would be simulated, run nothing",
    "scenes": "list the shipped scenes",
    "models": "list the material laws, or explain one",
    "drive": "try a material law: one point along a path of strains and stresses",
    "bench": "measure the speed of this machine",
    "study": "run a study of many runs and write its report; matpoint study --help lists them",
}
EXAMPLES = """examples:
  matpoint compare taylor-copper-jc --out results/copper
  matpoint run taylor-classic --method mpm --resolution 16 --wall plane
  matpoint models johnson_cook
  matpoint drive taylor-copper-jc --to 0.3 --rate 1000
  matpoint study work-precision taylor-classic

Each command has --help with examples, and --json. Exit status: 0 done; 1 a study's criterion is not met; 2 bad input;
3 a run went wrong, or the disk is full; 130 interrupted.
"""
BAD_INPUT, DISK_FULL, INTERRUPTED = 2, 3, 130


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command; returns its exit status, which EXAMPLES explains."""
    tolerate_any_text()
    tell_warnings_once()
    options = None
    try:
        with interruptible():
            check_own_packages()
            options = _parse(list(sys.argv[1:] if arguments is None else arguments))
            status = options.execute(options)
            sys.stdout.flush()
            return status
    except KeyboardInterrupt as interrupt:
        going_on = ": --resume with its folder goes on" if hasattr(options, "resume") else ""
        print(f"matpoint: interrupted; what had been written is kept{going_on}", file=sys.stderr)
        return getattr(interrupt, "exit_status", INTERRUPTED)
    except BrokenPipeError:
        discard_output()
        return 0
    except OSError as error:
        discard_output()
        print(f"matpoint: {error.filename or 'output'}: {error.strerror or error}", file=sys.stderr)
        return DISK_FULL if error.errno in (errno.ENOSPC, errno.EDQUOT) else BAD_INPUT
    except Exception as error:
        # MatpointError is known by its status: importing it here would load the compiler for --help.
        status = getattr(error, "exit_status", None)
        if status is None:
            raise
        print(f"matpoint: {' '.join(str(error).splitlines())}", file=sys.stderr)
        return status


def _parse(arguments: list[str]) -> argparse.Namespace:
    parser = Parser(
        prog="matpoint",
        description="Impact by the material point and the finite element method, with one set of material laws.",
        epilog=EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    verbs = parser.add_subparsers(title="commands", metavar="COMMAND", required=True)
    asked = next((word for word in arguments if not word.startswith("-")), None)
    for verb, summary in VERBS.items():
        own = verbs.add_parser(verb, help=summary, formatter_class=argparse.RawDescriptionHelpFormatter)
        if verb == asked:
            module = import_module(f"studies.commands.{verb}")
            own.description, own.epilog = module.__doc__.split("\n\n", 1)
            module.add_options(own)
            own.set_defaults(execute=module.execute, known_options=own.option_names)
    return parser.parse(arguments)

"""Run a study and write its report.

examples:
  matpoint study verification --quick
  matpoint study verification --only mms-vortex,plate-impact --out results/verification
  matpoint study necking

A study runs problems with known answers by several methods and says which criteria are met. It writes results.json and
report.html. verification takes about 20 minutes on one core, --quick about 2; necking pulls a bar until it necks, by
implicit and explicit finite elements and the material point method, in about 5 minutes, --quick in half a minute.
Exit status: 0 when every criterion is met; 1 when some is not; 2 bad input.
"""

import argparse
from pathlib import Path

from core_models.errors import SceneError
from core_models.names import suggestion
from studies.default_folder import default_folder
from studies.options import names

STUDIES = ("verification", "necking")
UNMET = 1


def add_options(parser: argparse.ArgumentParser) -> None:
    """Options of `matpoint study`."""
    parser.add_argument("study", metavar="STUDY", help=" or ".join(STUDIES))
    parser.add_argument("--only", metavar="NAME[,NAME...]", type=names, help="these problems (default: all)")
    parser.add_argument("--quick", action="store_true", help="coarser and fewer runs, the same criteria")
    parser.add_argument(
        "--out", metavar="DIR", help="new or empty folder for the results (default: results/STUDY-DATE-TIME)"
    )


def execute(options: argparse.Namespace) -> int:
    """Run the problems one after the other, print their verdicts and where the report is."""
    if options.study not in STUDIES:
        raise SceneError(f"no study is called {options.study!r}; {suggestion(options.study, STUDIES)}")
    from studies.verification.study import STUDIES as PROBLEMS_OF
    from studies.verification.study import verify
    from studies.verification.text import outcome_text

    out = Path(options.out or default_folder(options.study))
    results = verify(
        options.only or tuple(PROBLEMS_OF[options.study]),
        options.quick,
        out,
        tell=lambda problem, outcome: print(outcome_text(problem, outcome), flush=True),
        study=options.study,
    )
    page = out / "report.html"
    print(page if page.exists() else out / "results.json")
    return 0 if all(criterion.met for _, outcome in results for criterion in outcome.criteria) else UNMET

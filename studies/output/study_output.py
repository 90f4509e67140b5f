"""What the command of a study prints when it has ended."""

import sys
from pathlib import Path

from studies.output.json_output import print_results


def print_study(folder: Path, text: str, remark: str, *, as_json: bool) -> None:
    """The tables and, last, where the report is; with `as_json` results.json instead. remark : why there is no page."""
    if remark:
        print(f"matpoint: {remark}", file=sys.stderr)
    if as_json:
        print_results(folder)
        return
    print(f"{text}\n\n{folder / ('report.md' if remark else 'report.html')}")

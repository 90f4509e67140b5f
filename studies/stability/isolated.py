"""A cell in a process of its own, with limits of time and memory: what hangs or crashes is a failure, not the end."""

import json
import resource
import subprocess
import sys
from collections.abc import Callable
from typing import Any

from studies.stability.cell import FAILED, Cell, as_json

TIME_LIMIT = 300.0  # s
MEMORY_LIMIT = 6 * 2**30  # bytes


def run_isolated(case: str, variant: str, quick: bool, within: float = TIME_LIMIT) -> dict[str, Any]:
    """The result of `studies.stability.cell` as plain data; a process that dies or takes too long has failed."""
    command = [sys.executable, "-m", "studies.stability.cell", case, variant, *(["--quick"] if quick else [])]
    return judged(case, variant, command, within)


def judged(case: str, variant: str, command: list[str], within: float) -> dict[str, Any]:
    """Run a command that prints a cell; what else it does is why the cell has failed."""
    try:
        ended = subprocess.run(
            command, capture_output=True, text=True, timeout=within, preexec_fn=_limited(), check=False
        )
    except subprocess.TimeoutExpired:
        return _failed(case, variant, f"not at its end after {within:g} s")
    if ended.returncode < 0:
        return _failed(case, variant, f"crashed with signal {-ended.returncode}")
    try:
        return json.loads(ended.stdout.splitlines()[-1])
    except (json.JSONDecodeError, IndexError):
        said = (ended.stderr.strip().splitlines() or ["nothing said"])[-1]
        return _failed(case, variant, f"ended with status {ended.returncode}: {said}")


def _limited() -> Callable[[], None]:
    def limit() -> None:
        resource.setrlimit(resource.RLIMIT_DATA, (MEMORY_LIMIT, MEMORY_LIMIT))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))

    return limit


def _failed(case: str, variant: str, why: str) -> dict[str, Any]:
    return as_json(Cell(case, variant, FAILED, why))

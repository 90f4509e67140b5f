"""One job of a sweep, and how it ends."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from core_models.errors import MatpointError, RunFailure
from studies.sweep.remarks import remarks

COMPLETE, FAILED = "complete", "failed"


@dataclass(frozen=True)
class Job:
    """A call of a module's function that gives a dictionary of JSON; `key` names it and its file."""

    key: str
    function: Callable[..., dict[str, Any]]
    arguments: tuple = ()


def perform(job: Job) -> dict[str, Any]:
    """The job's result with its status and its remarks; an error becomes status 'failed' and its message."""
    with remarks() as said:
        try:
            result = {"status": COMPLETE, "message": ""} | job.function(*job.arguments) | {"key": job.key}
        except MatpointError as error:
            result = failed(job.key, str(error), error.exit_status)
    return result | {"remarks": list(said)}


def failed(key: str, message: str, exit_status: int = RunFailure.exit_status) -> dict[str, Any]:
    """The result of a job that has not come to an end, and the exit status that a command owes to it."""
    return {"key": key, "status": FAILED, "message": message, "exit_status": exit_status}

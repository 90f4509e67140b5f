"""Going on with a run that was killed, interrupted, or ran out of disk."""

from dataclasses import replace
from pathlib import Path

from core_models.errors import OutputError
from studies.checkpointing.checkpoint_file import FILE, read_checkpoint
from studies.checkpointing.interval import Interval, read_interval
from studies.output.kept_file import read_object
from studies.output.output_folder import OutputFolder, ResumedFolder
from studies.runs.remaining import Remaining
from studies.runs.result import RunResult
from studies.runs.running import simulate
from studies.scenes.reader import read_scene

ANEW = "start it anew with matpoint run"


def resume(
    path: Path | str, *, threads: int | None = None, interval: Interval | None = None, progress: bool = False
) -> RunResult:
    """Go on with the run in a folder from its last checkpoint; the results are bitwise those of a run left alone.

    threads, interval : others than the run was started with, if given.
    Raises OutputError for a folder without a run to go on with, or that another process is writing to; RunFailure
    when the run goes wrong.
    """
    with ResumedFolder(path) as folder:
        record = folder.path / "run.json"
        if record.exists() and not can_go_on(folder):
            raise OutputError(f"{path}: {_why_not(read_object(record, ANEW).get('message', ''))}")
        result = go_on(folder, threads=threads, interval=interval, progress=progress)
    if result.failure is not None:
        raise result.failure
    return result


def _why_not(message: str) -> str:
    """Of the message what went wrong; its own remedy was for the run that there was."""
    if message:
        return f"the run there went wrong before its first checkpoint: {message.partition(';')[0]}; {ANEW}"
    return "the run there has ended; nothing is left to resume"


def can_go_on(folder: OutputFolder) -> bool:
    """Whether a folder holds a checkpoint."""
    return (folder.path / FILE).exists()


def go_on(
    folder: OutputFolder,
    *,
    threads: int | None = None,
    interval: Interval | None = None,
    progress: bool = False,
    remaining: Remaining | None = None,
) -> RunResult:
    """Like `resume`, in a folder that is already ours; a run that goes wrong is recorded, not raised."""
    saved = read_checkpoint(folder.path)
    settings = saved.settings
    saved = replace(saved, spent=replace(saved.spent, resumed=saved.spent.resumed + 1))
    return simulate(
        read_scene(folder.path / "scene.xml"),
        settings.method,
        settings.resolution,
        wall=settings.wall,
        threads=threads or settings.threads,
        folder=folder,
        progress=progress,
        remaining=remaining,
        interval=interval or read_interval(settings.interval),
        saved=saved,
    )
